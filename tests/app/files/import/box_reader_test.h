#pragma once

#include <gtest/gtest.h>

#include "app/files/import/import_protocol.h"
#include "app/files/io/errors.h"
#include "sim/repair/soup_inspection.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {

/// Tests of what reads one format, by texts of a closed box of 1 x 2 x 3.
template <ImportedModel (*Read)(const std::filesystem::path&)>
class BoxReaderTest : public ::testing::Test {
  protected:
    ImportedModel read(const std::string& bytes) {
        test::writeText(folder_ / "a.model", bytes);
        return Read(folder_ / "a.model");
    }
    /// Why the bytes are refused; empty where they are read.
    std::string sentence(const std::string& bytes) {
        try {
            read(bytes);
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    }
    /// That the bytes are the box. Returns what was read.
    ImportedModel expectBox(const std::string& bytes) {
        ImportedModel model = read(bytes);
        const MeshReport report = inspectTriangles(model.soup);
        EXPECT_TRUE(report.cuttable) << report.problem << "\n" << bytes;
        EXPECT_EQ(report.triangles, 12) << bytes;
        EXPECT_NEAR(report.volume, 6, 1e-12) << bytes;
        return model;
    }

    test::TemporaryFolder folder_;
};

}  // namespace kerf::app
