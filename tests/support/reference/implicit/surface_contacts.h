#pragma once

#include "tests/support/reference/implicit/contact_row.h"
#include "tests/support/reference/reference_contact.h"

namespace kerf {

/// Vertices of a body that meet its own triangles or a floor, one row each.
class SurfaceContacts : public ContactFinder {
  public:
    /// `model` must outlive it. `floor`: its height [m]; none without a value.
    SurfaceContacts(const BodyModel& model, double friction, std::optional<double> floor,
                    bool pieces = true);

    ContactRows find(const ReferenceState& state, double step) override;

  private:
    void addFloor(const ReferenceState& state, double step, ContactRows& rows) const;
    void addSurfaces(const ReferenceState& state, double step, ContactRows& rows) const;

    const BodyModel& model_;
    double friction_;
    std::optional<double> floor_;
    bool pieces_;
};

}  // namespace kerf
