#pragma once

namespace kerf {

/// What a body has after a step [J].
struct BodyEnergies {
    double moving = 0;     ///< kinetic and strain energy
    double potential = 0;  ///< in the field of gravity
};

/// Finds out that a body gains energy of itself, as none does whose steps are short enough, and
/// into how many parts its coming steps are to be divided therefore. The state of a body: it is
/// stored with it.
class EnergyGuard {
  public:
    /// What was changed before the coming step, or is new, may have another energy.
    void startAnew() { isNew_ = true; }
    /// After a step of `h` seconds; `worked`: something else may have given energy; `least`: less
    /// is nothing [J]. Returns whether the steps are divided further now.
    bool note(const BodyEnergies& body, double h, bool worked, double least);
    /// Of a step that would do for what does not grow.
    int divisions() const { return divisions_; }

    /// Writes or reads all of it (ByteArchive).
    template <class Archive>
    void archive(Archive& io) {
        io(isNew_, highest_, divisions_, calm_);
    }

  private:
    bool isNew_ = true;
    double highest_ = 0;  ///< energy of late [J]
    int divisions_ = 1;
    double calm_ = 0;  ///< time since it grew [s]
};

}  // namespace kerf
