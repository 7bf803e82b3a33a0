-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 7: a voided session may be counted again. The session's own row tells what holds now; what was decided before, and taken back, is
-- kept here: each voiding that was taken back, and each taking back, with who, when and why. Reasons are covered through their hash; empty once
-- somebody concerned is erased.

CREATE TABLE session_decision (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    session_id INTEGER NOT NULL REFERENCES session (id),
    decision TEXT NOT NULL CHECK (decision IN ('void', 'reinstate')),
    person_id INTEGER NOT NULL REFERENCES person (id),
    utc TEXT NOT NULL,
    reason TEXT NOT NULL,
    reason_hash BLOB NOT NULL CHECK (length(reason_hash) = 32),
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;
CREATE INDEX session_decision_by_session ON session_decision (session_id, id);
CREATE INDEX session_decision_by_person ON session_decision (person_id, id);
CREATE TRIGGER session_decision_stays BEFORE DELETE ON session_decision
    BEGIN SELECT RAISE(ABORT, 'decisions are never deleted'); END;
CREATE TRIGGER session_decision_fixed
    BEFORE UPDATE OF id, session_id, decision, person_id, utc, reason_hash, digest ON session_decision
    BEGIN SELECT RAISE(ABORT, 'decisions are never changed'); END;

-- Which attempt of its person a session is (repositories/session_attempts.h) is counted in this index alone.
CREATE INDEX session_by_attempt ON session (person_id, exercise, level, id, familiarisation, operator_name, demonstration);
