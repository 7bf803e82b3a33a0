// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace chiron::core {

/// Type of a failure. The command line maps it to its exit status (cli.md), the desktop to a text.
enum class ErrorCode {
    wrongUse,    ///< command line or call used wrongly (exit 2)
    notAllowed,  ///< the actor's roles do not permit it (exit 2)
    badInput,    ///< a file, packet or value is malformed (exit 3)
    notFound,    ///< the thing asked for does not exist (exit 3)
    storage,     ///< database, file system, disk full (exit 4)
    locked,      ///< another program holds the writer's lock (exit 4)
    device,      ///< device missing, refused or faulted (exit 5)
    doesNotHold, ///< a check failed: the statement checked does not hold (exit 1)
    cancelled,   ///< cancelled by the person
};

/// An expected failure: a code for programs and a message for people that names the location (file, line,
/// JSON path, table), the value found and what was expected.
struct Error {
    ErrorCode code = ErrorCode::badInput;
    std::string message;
};

/// Either a value or an Error; nothing is thrown. Programming errors are asserts instead.
template <class T> using Result = tl::expected<T, Error>;

inline tl::unexpected<Error> fail(ErrorCode code, std::string message) {
    return tl::unexpected<Error>(Error{code, std::move(message)});
}

/// Whether the result failed for this reason, which the caller can answer; any other failure is passed on.
template <class T> bool failedAs(const Result<T>& result, ErrorCode code) {
    return !result && result.error().code == code;
}

} // namespace chiron::core

/// Ends the function with the error of a Result that failed; otherwise does nothing. The function returns a
/// Result, or something else that an unexpected error converts to.
#define CHIRON_TRY(...)                                                                                      \
    do {                                                                                                     \
        if (auto&& chironTried = (__VA_ARGS__); !chironTried)                                                \
            return tl::unexpected(std::forward<decltype(chironTried)>(chironTried).error());                 \
    } while (false)
