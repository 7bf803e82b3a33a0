-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 5: the run of a study that a session was recorded for, noted as the session begins. A session in which no trial was stored (the
-- free minute before the first trial, a sitting that was left at once) is a participant's recording, too, and is erased with the others.

CREATE TABLE study_sitting (
    id INTEGER PRIMARY KEY REFERENCES session (id),
    run_id INTEGER NOT NULL REFERENCES study_run (id),
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;
CREATE INDEX study_sitting_by_run ON study_sitting (run_id, id);
CREATE TRIGGER study_sitting_stays BEFORE DELETE ON study_sitting
    BEGIN SELECT RAISE(ABORT, 'sittings are never deleted'); END;
CREATE TRIGGER study_sitting_fixed BEFORE UPDATE ON study_sitting
    BEGIN SELECT RAISE(ABORT, 'sittings are never changed'); END;

-- Sessions of earlier versions are known by their trials alone.
CREATE VIEW recorded_sitting (session_id, run_id) AS
    SELECT id, run_id FROM study_sitting
    UNION SELECT session_id, run_id FROM study_trial WHERE session_id IS NOT NULL;
