// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_csv.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace chiron::scoring {

core::Result<TraceRows> readTraceCsvFile(const std::string& path) {
    constexpr std::uintmax_t kLargest = std::uintmax_t{2} << 30;
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        return core::fail(core::ErrorCode::notFound, path + ": expected a trace file that can be read");
    const std::uintmax_t size = std::filesystem::file_size(path, error);
    const auto tooLarge = [&] {
        return core::fail(core::ErrorCode::badInput, path + ": expected a trace file of at most 2 GiB");
    };
    if (error || size > kLargest)
        return tooLarge();
    std::ifstream file(path, std::ios::binary);
    if (!file)
        return core::fail(core::ErrorCode::notFound, path + ": expected a trace file that can be read");
    std::string text;
    text.reserve(static_cast<std::size_t>(size));
    std::array<char, 1 << 16> part{};
    do { // reads to the file's end, which may move meanwhile
        file.read(part.data(), part.size());
        text.append(part.data(), static_cast<std::size_t>(file.gcount()));
        if (text.size() > kLargest)
            return tooLarge();
    } while (file);
    if (file.bad())
        return core::fail(core::ErrorCode::storage,
                          path + ": broke off after " + std::to_string(text.size()) +
                              " bytes: expected a file that can be read to its end");
    if (!text.empty() && text.back() != '\n')
        return core::fail(
            core::ErrorCode::badInput,
            path + ": the last line has no line feed: expected one after every row, or the file was cut off");
    return readTraceCsv(text, path);
}

} // namespace chiron::scoring
