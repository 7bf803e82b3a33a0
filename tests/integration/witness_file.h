// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>

/// How far a watched program has come.
enum class Stage : std::uint32_t { launched, recovering, recovered, finishing, returned };

/// What a program that is to be killed says of itself, in memory that its death does not take away.
struct Witness {
    std::atomic<std::uint64_t> frames{0}; ///< pushed into the recording before this number was raised
    std::atomic<std::uint64_t> gaps{0};   ///< frames whose index was not the one before plus one
    std::atomic<Stage> stage{Stage::launched};
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

/// A file of one Witness, mapped by the program and by its parent. Not copied: the mapping is its own.
class WitnessFile {
public:
    /// A new, zeroed file, or the existing one. Ends the program if it cannot be mapped.
    static std::unique_ptr<WitnessFile> create(const std::string& path);
    static std::unique_ptr<WitnessFile> open(const std::string& path);
    WitnessFile(const WitnessFile&) = delete;
    WitnessFile& operator=(const WitnessFile&) = delete;
    ~WitnessFile();

    Witness& operator*() const noexcept { return *m_witness; }
    Witness* operator->() const noexcept { return m_witness; }

private:
    explicit WitnessFile(int descriptor);
    Witness* m_witness = nullptr;
};
