#include "ui/base/unit_text.h"

#include "sim/base/params.h"

namespace kerf::ui {
namespace {

TEST(TypedUnits, ANumberAloneIsInTheUnitOfItsField) {
    for (const char* unit : {"m", "mm", "Pa", "kg/m^3", "%", "", "file units"}) {
        EXPECT_EQ(readNumber("2.5", unit), 2.5) << unit;
        EXPECT_EQ(readNumber(" +1e-2 ", unit), 0.01) << unit;
        EXPECT_EQ(readNumber("-0,5", unit), -0.5) << unit;
    }
}

TEST(TypedUnits, EachKindIsConverted) {
    struct Row {
        const char* text;
        const char* unit;
        double number;
    };
    for (const Row& row : {Row{"5 mm", "m", 0.005},
                           {"12 cm", "m", 0.12},
                           {"12cm", "mm", 120},
                           {"0.1 m", "mm", 100},
                           {"250 \u00b5m", "mm", 0.25},
                           {"2 in", "mm", 50.8},
                           {"2 kPa", "Pa", 2000},
                           {"0.3 MPa", "Pa", 3e5},
                           {"0.3 s", "s", 0.3},
                           {"3 ms", "s", 0.003},
                           {"3 g/cm3", "kg/m^3", 3000},
                           {"1,2 g/cm\u00b3", "kg/m\u00b3", 1200},
                           {"900 kg/m^3", "kg/m^3", 900},
                           {"5 mm/s", "m/s", 0.005},
                           {"-981 cm/s2", "m/s^2", -9.81},
                           {"1 kJ/m2", "J/m\u00b2", 1000},
                           {"2 1/s", "1/s", 2},
                           {"20 mN", "N", 0.02},
                           {"15 deg", "\u00b0", 15},
                           {"5 %", "%", 5}}) {
        const std::optional<double> number = readNumber(row.text, row.unit);
        ASSERT_TRUE(number) << row.text;
        EXPECT_DOUBLE_EQ(*number, row.number) << row.text;
    }
}

TEST(TypedUnits, AnotherKindAndGarbageAreRefused) {
    for (const char* text :
         {"5 s", "5 kPa", "5 m2", "5 furlongs", "5 5", "5 MM", "mm", "five", "", "nan", "inf",
          "1e999", "0x10", "5 mm mm", "5 /", "--5", "5;", "5 \xff"}) {
        EXPECT_EQ(readNumber(text, "m"), std::nullopt) << text;
    }
    EXPECT_EQ(readNumber("5 mm", ""), std::nullopt);
    EXPECT_EQ(readNumber("5 mm", "file units"), std::nullopt);
}

TEST(TypedUnits, ASentenceSaysWhatFits) {
    EXPECT_EQ(whatFits("m"), "Type a length, such as 5 mm");
    EXPECT_EQ(whatFits("mm"), "Type a length, such as 5 mm");
    EXPECT_EQ(whatFits(""), "Type a number, such as 2");
    for (const ParamInfo& info : paramTable()) {
        const std::string fits = whatFits(info.unit);
        const std::string example = fits.substr(fits.rfind("as ") + 3);
        EXPECT_TRUE(readNumber(example, info.unit)) << info.name << ": " << fits;
        EXPECT_EQ(info.unit.empty(), fits == whatFits("")) << info.name << " has a known unit";
    }
}

}  // namespace
}  // namespace kerf::ui
