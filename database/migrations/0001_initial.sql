-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 1. Never edited once landed: later changes are later files.
-- Every number has a CHECK (SQLite turns NaN into NULL and stores infinity). `digest` is BLAKE2b-256 over a canonical
-- encoding of the row (integrity/row_digest.h); payloads and free texts are covered through their own hash, so that an
-- erasure leaves digests, seals and the audit chain as they were.

CREATE TABLE meta (
    key TEXT PRIMARY KEY NOT NULL,
    value TEXT NOT NULL
) STRICT;

CREATE TABLE person (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    kind TEXT NOT NULL CHECK (kind IN ('person', 'simulated', 'erased')),
    name TEXT NOT NULL,
    name_key TEXT NOT NULL UNIQUE,
    display_name TEXT NOT NULL,
    roles TEXT NOT NULL,
    enabled INTEGER NOT NULL CHECK (enabled IN (0, 1)),
    created_utc TEXT NOT NULL,
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;

CREATE TABLE person_code (
    person_id INTEGER PRIMARY KEY REFERENCES person (id),
    code TEXT NOT NULL UNIQUE,
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;

CREATE TABLE credential (
    person_id INTEGER PRIMARY KEY REFERENCES person (id),
    password_hash TEXT NOT NULL,
    recovery_hash TEXT NOT NULL,
    must_change INTEGER NOT NULL CHECK (must_change IN (0, 1)),
    failures INTEGER NOT NULL CHECK (failures BETWEEN 0 AND 1000000000),
    wait_boot TEXT NOT NULL,
    wait_until_ns INTEGER NOT NULL CHECK (wait_until_ns >= 0),
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;

CREATE TABLE content (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    sha256 BLOB NOT NULL UNIQUE CHECK (length(sha256) = 32),
    json TEXT NOT NULL,
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;

CREATE TABLE session (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    person_id INTEGER NOT NULL REFERENCES person (id),
    exercise TEXT NOT NULL CHECK (exercise <> ''),
    level INTEGER NOT NULL CHECK (level BETWEEN 1 AND 1000000),
    content_id INTEGER NOT NULL REFERENCES content (id),
    seed INTEGER NOT NULL,
    operator_name TEXT NOT NULL,
    felt INTEGER NOT NULL CHECK (felt IN (0, 1)),
    device_json TEXT NOT NULL,
    mapping_json TEXT NOT NULL,
    supervisor_json TEXT NOT NULL,
    versions_json TEXT NOT NULL,
    build_id TEXT NOT NULL,
    cpu_class TEXT NOT NULL,
    force_limit_n REAL NOT NULL CHECK (force_limit_n BETWEEN 0.0 AND 1e6),
    planned_trials INTEGER NOT NULL CHECK (planned_trials BETWEEN 1 AND 1000000),
    familiarisation INTEGER NOT NULL CHECK (familiarisation IN (0, 1)),
    realtime INTEGER NOT NULL CHECK (realtime IN (0, 1)),
    demonstration INTEGER NOT NULL CHECK (demonstration IN (0, 1)),
    ring_file TEXT NOT NULL,
    channel_table BLOB NOT NULL,
    started_utc TEXT NOT NULL,
    utc_offset_min INTEGER NOT NULL CHECK (utc_offset_min BETWEEN -1440 AND 1440),
    state TEXT NOT NULL CHECK (state IN ('running', 'completed', 'stopped', 'interrupted', 'incomplete', 'faulted',
                                         'voided')),
    ended_utc TEXT NOT NULL,
    ticks INTEGER NOT NULL CHECK (ticks >= 0),
    frames INTEGER NOT NULL CHECK (frames >= 0),
    dropped INTEGER NOT NULL CHECK (dropped >= 0),
    chunks INTEGER NOT NULL CHECK (chunks >= 0),
    recording_bytes INTEGER NOT NULL CHECK (recording_bytes >= 0),
    loop_json TEXT NOT NULL,
    seal BLOB CHECK (seal IS NULL OR length(seal) = 32),
    archived INTEGER NOT NULL CHECK (archived IN (0, 1)),
    recording_erased INTEGER NOT NULL CHECK (recording_erased IN (0, 1)),
    void_reason TEXT NOT NULL,
    void_reason_hash BLOB CHECK (void_reason_hash IS NULL OR length(void_reason_hash) = 32),
    voided_by INTEGER REFERENCES person (id),
    state_before_void TEXT CHECK (state_before_void IS NULL OR state_before_void IN
        ('completed', 'stopped', 'interrupted', 'incomplete', 'faulted')),
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    CHECK ((state = 'voided') = (state_before_void IS NOT NULL)),
    CHECK ((state = 'running') = (seal IS NULL))
) STRICT;
CREATE INDEX session_by_person ON session (person_id, id);
CREATE INDEX session_by_exercise ON session (exercise, level, id);
CREATE INDEX session_by_state ON session (state, id);

CREATE TABLE trial (
    session_id INTEGER NOT NULL REFERENCES session (id),
    ordinal INTEGER NOT NULL CHECK (ordinal BETWEEN 0 AND 1000000),
    seed INTEGER NOT NULL,
    state TEXT NOT NULL CHECK (state IN ('completed', 'stopped', 'interrupted', 'incomplete', 'faulted')),
    first_tick INTEGER NOT NULL CHECK (first_tick >= 0),
    last_tick INTEGER NOT NULL CHECK (last_tick >= first_tick),
    marked INTEGER NOT NULL CHECK (marked IN (0, 1)),
    timed_out INTEGER NOT NULL CHECK (timed_out IN (0, 1)),
    scene_json TEXT NOT NULL,
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    UNIQUE (session_id, ordinal)
) STRICT;

CREATE TABLE chunk (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    session_id INTEGER NOT NULL REFERENCES session (id),
    sequence INTEGER NOT NULL CHECK (sequence BETWEEN 0 AND 4294967295),
    first_tick INTEGER NOT NULL CHECK (first_tick >= 0),
    frames INTEGER NOT NULL CHECK (frames BETWEEN 1 AND 4294967295),
    payload BLOB NOT NULL,
    payload_hash BLOB NOT NULL CHECK (length(payload_hash) = 32),
    payload_digest BLOB NOT NULL CHECK (length(payload_digest) = 32),
    force_hash BLOB NOT NULL CHECK (length(force_hash) = 32),
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    UNIQUE (session_id, sequence)
) STRICT;

CREATE TABLE second_summary (
    session_id INTEGER NOT NULL REFERENCES session (id),
    second INTEGER NOT NULL CHECK (second BETWEEN 0 AND 4294967295),
    tool INTEGER NOT NULL CHECK (tool BETWEEN 0 AND 3),
    frames INTEGER NOT NULL CHECK (frames BETWEEN 0 AND 4294967295),
    path_length_m REAL NOT NULL CHECK (path_length_m BETWEEN 0.0 AND 1.7976931348623157e308),
    maximum_force_n REAL NOT NULL CHECK (maximum_force_n BETWEEN 0.0 AND 1.7976931348623157e308),
    mean_force_n REAL NOT NULL CHECK (mean_force_n BETWEEN 0.0 AND 1.7976931348623157e308),
    impulse_ns REAL NOT NULL CHECK (impulse_ns BETWEEN 0.0 AND 1.7976931348623157e308),
    time_over_limit_s REAL NOT NULL CHECK (time_over_limit_s BETWEEN 0.0 AND 1.7976931348623157e308),
    events INTEGER NOT NULL CHECK (events BETWEEN 0 AND 4294967295),
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    UNIQUE (session_id, second, tool)
) STRICT;

CREATE TABLE event (
    session_id INTEGER NOT NULL REFERENCES session (id),
    ordinal INTEGER NOT NULL CHECK (ordinal >= 0),
    tick INTEGER NOT NULL CHECK (tick >= 0),
    time_s REAL NOT NULL CHECK (time_s BETWEEN 0.0 AND 1e12),
    tool INTEGER NOT NULL CHECK (tool BETWEEN 0 AND 3),
    kind TEXT NOT NULL CHECK (kind <> ''),
    detail_json TEXT NOT NULL,
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    UNIQUE (session_id, ordinal)
) STRICT;

CREATE TABLE score_set (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    session_id INTEGER NOT NULL REFERENCES session (id),
    ordinal INTEGER NOT NULL CHECK (ordinal BETWEEN 1 AND 1000000),
    utc TEXT NOT NULL,
    passed INTEGER NOT NULL CHECK (passed IN (0, 1)),
    trials INTEGER NOT NULL CHECK (trials BETWEEN 0 AND 1000000),
    scores INTEGER NOT NULL CHECK (scores >= 0),
    seal BLOB NOT NULL CHECK (length(seal) = 32),
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    UNIQUE (session_id, ordinal)
) STRICT;

-- trial -1 is the whole session; ordinal keeps the card's order.
CREATE TABLE score (
    score_set_id INTEGER NOT NULL REFERENCES score_set (id),
    trial INTEGER NOT NULL CHECK (trial BETWEEN -1 AND 1000000),
    ordinal INTEGER NOT NULL CHECK (ordinal BETWEEN 0 AND 1000000),
    metric TEXT NOT NULL CHECK (metric <> ''),
    version INTEGER NOT NULL CHECK (version BETWEEN 1 AND 1000000),
    unit TEXT NOT NULL,
    value REAL CHECK (value IS NULL OR value BETWEEN -1.7976931348623157e308 AND 1.7976931348623157e308),
    reason TEXT NOT NULL,
    passed INTEGER CHECK (passed IS NULL OR passed IN (0, 1)),
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    CHECK ((value IS NULL) = (reason <> '')),
    UNIQUE (score_set_id, trial, metric)
) STRICT;

CREATE TABLE session_comment (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    session_id INTEGER NOT NULL REFERENCES session (id),
    author_id INTEGER NOT NULL REFERENCES person (id),
    utc TEXT NOT NULL,
    text TEXT NOT NULL,
    text_hash BLOB NOT NULL CHECK (length(text_hash) = 32),
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;
CREATE INDEX session_comment_by_session ON session_comment (session_id, id);
CREATE INDEX session_comment_by_author ON session_comment (author_id, id);

CREATE TABLE erasure (
    person_id INTEGER PRIMARY KEY REFERENCES person (id),
    utc TEXT NOT NULL,
    reason TEXT NOT NULL,
    administrator_id INTEGER NOT NULL REFERENCES person (id),
    recordings_withdrawn INTEGER NOT NULL CHECK (recordings_withdrawn IN (0, 1)),
    digests_json TEXT NOT NULL,
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;

CREATE TABLE audit (
    sequence INTEGER PRIMARY KEY CHECK (sequence > 0),
    utc TEXT NOT NULL,
    actor_kind TEXT NOT NULL,
    actor_id INTEGER NOT NULL CHECK (actor_id >= 0),
    action TEXT NOT NULL,
    target TEXT NOT NULL,
    target_id INTEGER NOT NULL,
    detail_json TEXT NOT NULL,
    previous BLOB NOT NULL CHECK (length(previous) = 32),
    mac BLOB NOT NULL CHECK (length(mac) = 32)
) STRICT;
CREATE INDEX audit_by_target ON audit (target, target_id, sequence);
CREATE INDEX audit_by_actor ON audit (actor_id, sequence);

-- Archive and void, never delete.
CREATE TRIGGER person_stays BEFORE DELETE ON person BEGIN SELECT RAISE(ABORT, 'people are never deleted'); END;
CREATE TRIGGER session_stays BEFORE DELETE ON session BEGIN SELECT RAISE(ABORT, 'sessions are never deleted'); END;
CREATE TRIGGER trial_stays BEFORE DELETE ON trial BEGIN SELECT RAISE(ABORT, 'trials are never deleted'); END;
CREATE TRIGGER chunk_stays BEFORE DELETE ON chunk BEGIN SELECT RAISE(ABORT, 'chunks are never deleted'); END;
CREATE TRIGGER score_stays BEFORE DELETE ON score BEGIN SELECT RAISE(ABORT, 'scores are never deleted'); END;
CREATE TRIGGER score_fixed BEFORE UPDATE ON score BEGIN SELECT RAISE(ABORT, 'scores are never changed'); END;
CREATE TRIGGER audit_stays BEFORE DELETE ON audit BEGIN SELECT RAISE(ABORT, 'the audit is never deleted'); END;
CREATE TRIGGER audit_fixed BEFORE UPDATE ON audit BEGIN SELECT RAISE(ABORT, 'the audit is never changed'); END;
