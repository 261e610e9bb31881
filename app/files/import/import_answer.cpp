#include "app/files/import/import_answer.h"

#include "app/files/io/encodings.h"
#include "app/files/io/errors.h"
#include "sim/base/byte_archive.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

/// Of another version of Kerf, an answer is none.
const std::string kMagic = "kerf-import 1";

std::span<const std::byte> bytesOf(std::string_view text) {
    return std::as_bytes(std::span(text));
}

template <class T>
std::string encoded(const T& value) {
    ByteWriter out;
    out(kMagic, value);
    return {reinterpret_cast<const char*>(out.bytes.data()), out.bytes.size()};
}

/// So many values, and nothing else.
template <class T>
std::vector<T> decoded(std::string_view bytes, std::size_t count) {
    ByteReader in(bytesOf(bytes));
    std::string magic;
    std::vector<T> values;
    try {
        do {
            in(magic, values.emplace_back());
        } while (magic == kMagic && values.size() < count);
    } catch (const std::out_of_range&) {
        magic.clear();
    }
    if (magic != kMagic || !in.isAtEnd()) {
        throw InputError(
            "the model reader stopped in the middle, or is of another version; the file may be "
            "damaged, or Kerf needs to be rebuilt");
    }
    return values;
}

void checkIndices(const TriangleSoup& soup) {
    const int count = static_cast<int>(soup.positions.size());
    const auto bad = std::ranges::count_if(soup.triangles, [&](const Triangle& t) {
        return std::ranges::any_of(t, [&](int v) { return v < 0 || v >= count; });
    });
    const auto fits = [&](const auto& list) {
        return list.empty() || list.size() == soup.triangles.size();
    };
    const bool fit = fits(soup.skin.uvs) && fits(soup.skin.colors) && fits(soup.skin.materials) &&
                     fits(soup.objects);
    if (bad > 0 || !fit || soup.triangles.size() > kMaxImportTriangles) {
        throw InputError(
            "the model reader names a vertex or a triangle that is not there; the "
            "file is damaged, export it again");
    }
}

/// Numbers that are none become 0.
template <class Values>
void clearOdd(std::vector<Values>& triangles) {
    for (Values& corners : triangles) {
        for (auto& value : corners) {
            if (!value.allFinite()) {
                value.setZero();
            }
        }
    }
}

/// A number in a list of so many, else `other`.
void keepBelow(int& number, std::size_t count, int other) {
    number = number >= 0 && std::size_t(number) < count ? number : other;
}

template <class Kind>
void keepKind(Kind& kind, std::size_t count) {
    int number = static_cast<int>(kind);
    keepBelow(number, count, 0);
    kind = static_cast<Kind>(number);
}

void clearOddNumbers(ImportedModel& model) {
    clearOdd(model.soup.skin.uvs);
    clearOdd(model.soup.skin.colors);
    for (int& object : model.soup.objects) {
        keepBelow(object, model.facts.objects.size(), 0);
    }
    for (int& material : model.soup.skin.materials) {
        keepBelow(material, model.appearance.materials.size(), -1);
    }
    for (render::SurfaceMaterial& material : model.appearance.materials) {
        keepBelow(material.image, model.appearance.images.size(), -1);
    }
    if (model.facts.units) {
        keepKind(model.facts.units->unit, std::size(kLengthUnitNames));
        keepKind(model.facts.units->up, std::size(kUpAxisNames));
    }
}

/// Names of a file are in lines and sentences.
void cleanNames(ImportedModel& model) {
    const auto clean = [](std::string& name) {
        std::ranges::replace_if(
            name, [](char c) { return c >= 0 && c < ' '; }, '_');
    };
    std::ranges::for_each(model.facts.objects, clean);
    std::ranges::for_each(model.remarks, clean);
    for (render::SurfaceMaterial& material : model.appearance.materials) {
        clean(material.name);
    }
    for (render::ModelImage& image : model.appearance.images) {
        clean(image.name);
        const std::size_t pixels = std::size_t(std::max(image.pixels.width, 0)) *
                                   std::size_t(std::max(image.pixels.height, 0));
        if (image.pixels.pixels.size() != 4 * pixels) {
            image.pixels = {};
        }
    }
}

}  // namespace

std::string encodeOrder(const ImportOrder& order) {
    return base64(encoded(order));
}

ImportOrder decodeOrder(std::string_view letters) {
    return decoded<ImportOrder>(bytesOfBase64(letters), 1).front();
}

std::string encodeAnswer(const ImportAnswer& answer) {
    return encoded(answer);
}

std::vector<ImportAnswer> decodeAnswers(std::string_view bytes, std::size_t count) {
    auto answers = decoded<ImportAnswer>(bytes, count);
    for (ImportAnswer& answer : answers) {
        keepKind(answer.outcome, kImportOutcomes);
        checkIndices(answer.model.soup);
        clearOddNumbers(answer.model);
        cleanNames(answer.model);
    }
    return answers;
}

}  // namespace kerf::app
