// One description of what a material file consists of. Reader, writer and the schema for text
// editors are made from it, as of session_table.h, whose words mean the same here.
#pragma once

#include "app/session/material.h"
#include "app/session/session_table.h"

namespace kerf::app {

inline constexpr FileFormat kMaterialFormat{"kerf-material", 1};
inline constexpr ShortText kNotes{400};
inline constexpr Limits kSpreads{0, 1e12};

/// The names of the properties, which sources refer to.
inline std::span<const std::string_view> propertyNames() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> collected;
        std::ranges::transform(materialProperties(), std::back_inserter(collected),
                               &MaterialProperty::name);
        return collected;
    }();
    return names;
}

void describe(auto& fields, MaterialValue& value, const Limits& limits = {}) {
    fields.required({"value", "A typical value."}, value.value, limits);
    fields.optional({"low", "The lower end of what is measured."}, value.low, kSpreads);
    fields.optional({"high", "The upper end."}, value.high, kSpreads);
    fields.check(value.low.has_value() == value.high.has_value(), "",
                 "a spread needs both \"low\" and \"high\".");
    fields.check(!value.low || *value.low <= *value.value, "low", "low must not be above value.");
    fields.check(!value.high || *value.high >= *value.value, "high",
                 "high must not be below value.");
}

void describe(auto& fields, MaterialSource& source) {
    fields.required({"of", "The values that it is about."}, source.of, Words{propertyNames()});
    fields.required({"text", "Authors, year, title, journal, table; or the reason of an estimate."},
                    source.text, kNotes);
    fields.optional({"says", "What stands there."}, source.says, kNotes);
    fields.optional({"doi", "Its DOI, without https://doi.org/."}, source.doi, kNotes);
    fields.optional({"estimate", "Whether this is an estimate that nobody has measured."},
                    source.estimate);
}

void describe(auto& fields, Material& material) {
    fields.ignored({"$schema", "The schema by which an editor checks this file. Kerf ignores it."});
    fields.format({"format", "Says that this is a material."},
                  {"version", "The version of the format."}, kMaterialFormat);
    fields.optional({"label", "What people read. The file's name where it is left out."},
                    material.label, kLabels);
    fields.optional({"about", "What exactly it is."}, material.about, kNotes);
    for (const MaterialProperty& property : materialProperties()) {
        fields.optional({property.name, property.meaning}, material.*property.member,
                        Limits{property.low, property.high});
    }
    fields.atLeastOneOf({"youngs_modulus", "density", "friction", "damping"},
                        "a material needs \"youngs_modulus\", \"density\", \"friction\" or "
                        "\"damping\".");
    fields.optional({"look", "What it looks like, as in the view of a session."}, material.colors);
    fields.list({"sources", "Where the values come from."}, material.sources, kMostSources);
}

}  // namespace kerf::app
