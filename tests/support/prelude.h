// What any test may use without a word, besides cmake/prelude.h: the rooms with more of it have a
// prelude of their own, which names this one (CMakeLists.txt). A file names what is not here, and
// what it is about. What a room has, too, keeps its qualifier, such as test::mirrorOf.
#pragma once

#include <glad/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <random>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "tests/paths.h"
#include "tests/support/fuzz_seed.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/nightly.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/variable.h"

namespace kerf {
namespace fs = std::filesystem;
using namespace test;
using testing::Contains;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;
using testing::UnorderedElementsAre;
}  // namespace kerf
