-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 3: studies of psychophysics. Codes stand everywhere; who a code is stands in participant_key alone. What an erasure must
-- overwrite (keys, answers) is kept as JSON with a random nonce in it and covered through its hash, so that neither a digest nor the
-- audit chain lets anybody guess it back.

CREATE TABLE study (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    key TEXT NOT NULL CHECK (key <> ''),
    title TEXT NOT NULL,
    state TEXT NOT NULL CHECK (state IN ('draft', 'frozen', 'closed')),
    design_json TEXT NOT NULL,
    sha256 BLOB CHECK (sha256 IS NULL OR length(sha256) = 32),
    author_id INTEGER NOT NULL REFERENCES person (id),
    created_utc TEXT NOT NULL,
    frozen_utc TEXT NOT NULL,
    unblinded INTEGER NOT NULL CHECK (unblinded IN (0, 1)),
    archived INTEGER NOT NULL CHECK (archived IN (0, 1)),
    demonstration INTEGER NOT NULL CHECK (demonstration IN (0, 1)),
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    CHECK ((state = 'draft') = (sha256 IS NULL))
) STRICT;
-- The simulated account (person 1) names its studies apart from people's.
CREATE UNIQUE INDEX study_by_key ON study (key, author_id = 1);

CREATE TABLE study_condition (
    study_id INTEGER NOT NULL REFERENCES study (id),
    ordinal INTEGER NOT NULL CHECK (ordinal BETWEEN 0 AND 1000),
    condition TEXT NOT NULL CHECK (condition <> ''),
    sealed_code TEXT NOT NULL CHECK (sealed_code <> ''),
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    UNIQUE (study_id, ordinal),
    UNIQUE (study_id, condition),
    UNIQUE (study_id, sealed_code)
) STRICT;

CREATE TABLE study_participant (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    study_id INTEGER NOT NULL REFERENCES study (id),
    code TEXT NOT NULL CHECK (code <> ''),
    order_row INTEGER NOT NULL CHECK (order_row BETWEEN 0 AND 1000000),
    state TEXT NOT NULL CHECK (state IN ('enrolled', 'consented', 'completed', 'withdrawn')),
    simulated INTEGER NOT NULL CHECK (simulated IN (0, 1)),
    observer TEXT NOT NULL,
    enrolled_by INTEGER NOT NULL REFERENCES person (id),
    enrolled_utc TEXT NOT NULL,
    erase_recordings INTEGER NOT NULL CHECK (erase_recordings IN (0, 1)),
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    CHECK ((simulated = 1) = (observer <> '')),
    UNIQUE (study_id, code)
) STRICT;
CREATE UNIQUE INDEX study_participant_code ON study_participant (code) WHERE simulated = 0;
CREATE UNIQUE INDEX study_participant_row ON study_participant (study_id, simulated, order_row) WHERE state <> 'withdrawn';

-- Who a code is: {"identity", "nonce", "person"}; empty once erased. The id is the participant's.
CREATE TABLE participant_key (
    id INTEGER PRIMARY KEY REFERENCES study_participant (id),
    key_json TEXT NOT NULL,
    key_hash BLOB NOT NULL CHECK (length(key_hash) = 32),
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;

CREATE TABLE participant_consent (
    id INTEGER PRIMARY KEY REFERENCES study_participant (id),
    sha256 BLOB NOT NULL CHECK (length(sha256) = 32),
    utc TEXT NOT NULL,
    recorded_by INTEGER NOT NULL REFERENCES person (id),
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;

CREATE TABLE study_run (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    participant_id INTEGER NOT NULL REFERENCES study_participant (id),
    condition TEXT NOT NULL CHECK (condition <> ''),
    sealed_code TEXT NOT NULL CHECK (sealed_code <> ''),
    position INTEGER NOT NULL CHECK (position BETWEEN 0 AND 1000),
    seed INTEGER NOT NULL,
    procedures TEXT NOT NULL CHECK (procedures <> ''),
    begun_by INTEGER NOT NULL REFERENCES person (id),
    state TEXT NOT NULL CHECK (state IN ('open', 'completed', 'stopped')),
    started_utc TEXT NOT NULL,
    ended_utc TEXT NOT NULL,
    trials INTEGER NOT NULL CHECK (trials BETWEEN 0 AND 10000000),
    seal BLOB CHECK (seal IS NULL OR length(seal) = 32),
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    CHECK ((state = 'open') = (seal IS NULL))
) STRICT;
CREATE INDEX study_run_by_participant ON study_run (participant_id, id);
CREATE UNIQUE INDEX study_run_once ON study_run (participant_id, condition) WHERE state <> 'stopped';

CREATE TABLE study_trial (
    run_id INTEGER NOT NULL REFERENCES study_run (id),
    ordinal INTEGER NOT NULL CHECK (ordinal BETWEEN 0 AND 10000000),
    procedure INTEGER NOT NULL CHECK (procedure BETWEEN 0 AND 1000),
    session_id INTEGER REFERENCES session (id),
    first_tick INTEGER NOT NULL CHECK (first_tick >= 0),
    last_tick INTEGER NOT NULL CHECK (last_tick >= first_tick),
    candidate INTEGER NOT NULL CHECK (candidate BETWEEN 0 AND 4095),
    arrangement INTEGER NOT NULL CHECK (arrangement BETWEEN 0 AND 15),
    difference REAL NOT NULL CHECK (difference BETWEEN -1000.0 AND 1000.0),
    entropy_margin REAL CHECK (entropy_margin IS NULL OR entropy_margin BETWEEN -1.7976931348623157e308 AND
        1.7976931348623157e308),
    answer INTEGER NOT NULL CHECK (answer BETWEEN -1 AND 1000),
    outcome INTEGER NOT NULL CHECK (outcome BETWEEN -1 AND 1000),
    value REAL CHECK (value IS NULL OR value BETWEEN -1.7976931348623157e308 AND 1.7976931348623157e308),
    exploration_s REAL NOT NULL CHECK (exploration_s BETWEEN 0.0 AND 1e9),
    answer_s REAL NOT NULL CHECK (answer_s BETWEEN 0.0 AND 1e9),
    practice INTEGER NOT NULL CHECK (practice IN (0, 1)),
    undone INTEGER NOT NULL CHECK (undone IN (0, 1)),
    spoiled TEXT NOT NULL,
    fidelity_json TEXT NOT NULL,
    utc TEXT NOT NULL,
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    UNIQUE (run_id, ordinal)
) STRICT;
CREATE INDEX study_trial_by_session ON study_trial (session_id) WHERE session_id IS NOT NULL;

-- {"nonce", "number" or "text"}; empty once erased.
CREATE TABLE questionnaire_answer (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    participant_id INTEGER NOT NULL REFERENCES study_participant (id),
    questionnaire TEXT NOT NULL CHECK (questionnaire <> ''),
    item TEXT NOT NULL CHECK (item <> ''),
    answer_json TEXT NOT NULL,
    answer_hash BLOB NOT NULL CHECK (length(answer_hash) = 32),
    utc TEXT NOT NULL,
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    UNIQUE (participant_id, questionnaire, item)
) STRICT;

CREATE TABLE participant_erasure (
    id INTEGER PRIMARY KEY REFERENCES study_participant (id),
    utc TEXT NOT NULL,
    reason TEXT NOT NULL,
    administrator_id INTEGER NOT NULL REFERENCES person (id),
    recordings_withdrawn INTEGER NOT NULL CHECK (recordings_withdrawn IN (0, 1)),
    digests_json TEXT NOT NULL,
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;

-- Archive, close and withdraw, never delete.
CREATE TRIGGER study_stays BEFORE DELETE ON study BEGIN SELECT RAISE(ABORT, 'studies are never deleted'); END;
CREATE TRIGGER study_condition_stays BEFORE DELETE ON study_condition
    BEGIN SELECT RAISE(ABORT, 'sealed codes are never deleted'); END;
CREATE TRIGGER study_participant_stays BEFORE DELETE ON study_participant
    BEGIN SELECT RAISE(ABORT, 'participants are never deleted'); END;
CREATE TRIGGER participant_key_stays BEFORE DELETE ON participant_key
    BEGIN SELECT RAISE(ABORT, 'keys are overwritten, never deleted'); END;
CREATE TRIGGER participant_consent_stays BEFORE DELETE ON participant_consent
    BEGIN SELECT RAISE(ABORT, 'consents are never deleted'); END;
CREATE TRIGGER study_run_stays BEFORE DELETE ON study_run BEGIN SELECT RAISE(ABORT, 'runs are never deleted'); END;
CREATE TRIGGER study_trial_stays BEFORE DELETE ON study_trial
    BEGIN SELECT RAISE(ABORT, 'study trials are never deleted'); END;
CREATE TRIGGER questionnaire_answer_stays BEFORE DELETE ON questionnaire_answer
    BEGIN SELECT RAISE(ABORT, 'answers are overwritten, never deleted'); END;
CREATE TRIGGER participant_erasure_stays BEFORE DELETE ON participant_erasure
    BEGIN SELECT RAISE(ABORT, 'tombstones are never deleted'); END;
-- What was frozen, sealed or said stays as it was.
CREATE TRIGGER study_frozen BEFORE UPDATE ON study
    WHEN OLD.state <> 'draft' AND (NEW.design_json IS NOT OLD.design_json OR NEW.sha256 IS NOT OLD.sha256 OR
        NEW.key IS NOT OLD.key OR NEW.title IS NOT OLD.title OR NEW.frozen_utc IS NOT OLD.frozen_utc OR
        NEW.author_id IS NOT OLD.author_id OR NEW.state = 'draft' OR NEW.unblinded < OLD.unblinded OR
        (OLD.state = 'closed' AND NEW.state <> 'closed'))
    BEGIN SELECT RAISE(ABORT, 'a frozen study is never changed'); END;
CREATE TRIGGER study_condition_fixed BEFORE UPDATE ON study_condition
    BEGIN SELECT RAISE(ABORT, 'sealed codes are never changed'); END;
CREATE TRIGGER study_participant_fixed BEFORE UPDATE ON study_participant
    WHEN NEW.study_id IS NOT OLD.study_id OR NEW.code IS NOT OLD.code OR NEW.order_row IS NOT OLD.order_row OR
        NEW.simulated IS NOT OLD.simulated OR NEW.observer IS NOT OLD.observer OR
        (OLD.state = 'withdrawn' AND NEW.state <> 'withdrawn')
    BEGIN SELECT RAISE(ABORT, 'a participant''s code and order are never changed'); END;
CREATE TRIGGER participant_consent_fixed BEFORE UPDATE ON participant_consent
    BEGIN SELECT RAISE(ABORT, 'consents are never changed'); END;
CREATE TRIGGER study_run_sealed BEFORE UPDATE ON study_run WHEN OLD.state <> 'open'
    BEGIN SELECT RAISE(ABORT, 'an ended run is never changed'); END;
CREATE TRIGGER study_trial_fixed BEFORE UPDATE ON study_trial
    BEGIN SELECT RAISE(ABORT, 'study trials are never changed'); END;
CREATE TRIGGER study_trial_sealed BEFORE INSERT ON study_trial
    WHEN (SELECT state FROM study_run WHERE id = NEW.run_id) <> 'open'
    BEGIN SELECT RAISE(ABORT, 'an ended run takes no more trials'); END;
