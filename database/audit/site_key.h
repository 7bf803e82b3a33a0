// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/integrity/row_digest.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

namespace chiron::database {

/// The secret key of the audit chain: 32 random bytes in "<site folder>/site.key" (0600), outside the
/// database. It is wiped from memory on destruction. Whoever holds it could forge the chain, so the chain
/// gives no protection against an administrator of the machine (data.md, Proof).
class SiteKey {
public:
    SiteKey(const SiteKey&) = delete;
    SiteKey& operator=(const SiteKey&) = delete;
    ~SiteKey();

    /// Creates the folder (0700) and a new key in it; an existing key is kept and loaded.
    /// Errors: storage.
    static core::Result<std::unique_ptr<SiteKey>> createOrLoad(const std::string& siteFolder);
    /// Errors: notFound; storage if others than the owner may read the file, or it is malformed.
    static core::Result<std::unique_ptr<SiteKey>> load(const std::string& siteFolder);

    /// Returns the keyed BLAKE2b-256 of the bytes.
    RowDigest mac(std::span<const std::uint8_t> bytes) const;
    const std::string& folder() const noexcept { return m_folder; }

private:
    explicit SiteKey(std::string folder) : m_folder(std::move(folder)) {}
    std::string m_folder;
    std::array<std::uint8_t, 32> m_key{};
};

} // namespace chiron::database
