// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/trace_csv.h"

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
    if (error || size > kLargest)
        return core::fail(core::ErrorCode::badInput, path + ": expected a trace file of at most 2 GiB");
    std::ifstream file(path, std::ios::binary);
    std::string text(static_cast<std::size_t>(size), '\0');
    if (!file || !file.read(text.data(), static_cast<std::streamsize>(size)))
        return core::fail(core::ErrorCode::notFound, path + ": expected a trace file that can be read");
    return readTraceCsv(text, path);
}

} // namespace chiron::scoring
