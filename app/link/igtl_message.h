#pragma once

#include "sim/base/math.h"

namespace kerf::app {

/// A message of OpenIGTLink: its content is without extended header and metadata.
struct IgtlMessage {
    std::string type;    ///< such as TRANSFORM, 12 letters at most
    std::string device;  ///< the name of what it tells of, 20 letters at most
    std::string content;
};

/// The bytes of a message of OpenIGTLink 1, which later versions read, too.
std::string packIgtl(const IgtlMessage& message);

/// Takes messages of OpenIGTLink 1 to 3 out of a stream of bytes that anyone may have sent.
class IgtlReader {
  public:
    void add(std::string_view bytes) { bytes_ += bytes; }
    /// The next message that is complete; none so far. Throws InputError where the stream holds no
    /// message, or too long a one; there is no next one then.
    std::optional<IgtlMessage> next();

  private:
    std::string bytes_;
};

/// Where a tool is, in the axes of the message.
struct IgtlPose {
    Vec3 position = Vec3::Zero();  ///< [mm]
    Vec3 zAxis = Vec3::UnitZ();    ///< the tool's own third axis, of length 1
};

/// The pose of a tool of this name in a TRANSFORM, POSITION or QTDATA; none in another message.
/// Throws InputError where such a message has another size than its type, or is no pose.
std::optional<IgtlPose> poseIn(const IgtlMessage& message, std::string_view tool);
/// The text of a STRING; none in another message. Throws InputError like the above.
std::optional<std::string> textIn(const IgtlMessage& message);

// Contents of messages to send.
std::string transformOf(const IgtlPose& pose);
std::string polyDataOf(std::span<const Vec3> points, std::span<const Triangle> triangles);
/// Three components of a force [N].
std::string sensorOf(const Vec3& force);
/// A text beyond 65,535 bytes is cut off there.
std::string stringOf(const std::string& text);
/// The status "OK".
std::string statusOf(const std::string& text);

}  // namespace kerf::app
