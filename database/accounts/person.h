// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/actor.h"

#include <string>

namespace chiron::database {

/// A person as the accounts show them.
struct Person {
    PersonId id = 0;
    std::string name; ///< login name, unique after case folding
    std::string displayName;
    std::string code; ///< pseudonym used in studies and for readers who may not see names
    RoleSet roles;
    bool enabled = true;
    bool mustChangePassword = false;
    std::string createdUtc;
};

/// What somebody was called until a change of name.
struct EarlierName {
    std::int64_t id = 0;
    std::string name;
    std::string displayName;
    std::string untilUtc;
    PersonId changedBy = 0;
};

/// A login name and a full name that somebody had until a change of either.
struct EarlierLogin {
    PersonId person = 0;
    std::string name;
    std::string displayName{}; ///< may be empty
};

/// Whom the login screen offers: no e-mail, no roles, no code.
struct LoginName {
    PersonId id = 0;
    std::string name;        ///< login name
    std::string displayName; ///< may be empty
};

/// A person to be created; the password is already hashed (PasswordHasher), so that no writer job waits for
/// Argon2id.
struct NewPerson {
    std::string name;
    std::string displayName;
    RoleSet roles;
    std::string passwordHash;
    bool mustChangePassword = false;
};

/// What a list of people changes about somebody who has an account already; the login name and the password
/// stay as they are.
struct PersonChange {
    PersonId id = 0;
    std::string displayName;
    RoleSet roles;
};

/// One stored attempt to log in, between beginLogin and finishLogin.
struct LoginAttempt {
    PersonId person = 0; ///< 0: no such account; hash something all the same, so that it takes as long
    std::string
        passwordHash; ///< what to verify against (password or recovery code); empty where there is nothing
    std::int64_t wait_ns = 0;        ///< > 0: the account must wait so long; nothing was counted
    std::int64_t waitIfWrong_ns = 0; ///< how long the next attempt must wait when this one is wrong
};

/// Why somebody was not let in.
struct Refusal {
    enum class Kind : std::uint8_t {
        wrong,    ///< name, password or code; not told which
        mustWait, ///< too many wrong ones: not even looked at
        disabled, ///< the password is right
        failed    ///< anything else: storage, rules; see error
    };
    Kind kind = Kind::failed;
    std::int64_t wait_ns = 0; ///< before the next attempt is looked at
    core::Error error;
};

} // namespace chiron::database
