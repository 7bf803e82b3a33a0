-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 6: a questionnaire may be asked after each condition, so an answer may belong to a run (NULL: given once), and each answer says in
-- which language its question was shown (NULL: not recorded). What was unique in the table was one answer to a question a participant; that
-- cannot be taken out of a table, so it is made anew, row by row and digest by digest. Rows without the new columns keep the digest that
-- earlier versions gave them (integrity/row_digest.h, laterColumns). No other table refers to this one.

CREATE TABLE questionnaire_answer_6 (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    participant_id INTEGER NOT NULL REFERENCES study_participant (id),
    questionnaire TEXT NOT NULL CHECK (questionnaire <> ''),
    item TEXT NOT NULL CHECK (item <> ''),
    answer_json TEXT NOT NULL,
    answer_hash BLOB NOT NULL CHECK (length(answer_hash) = 32),
    utc TEXT NOT NULL,
    digest BLOB NOT NULL CHECK (length(digest) = 32),
    run_id INTEGER REFERENCES study_run (id),
    language TEXT CHECK (language IS NULL OR language <> '')
) STRICT;
INSERT INTO questionnaire_answer_6 (id, participant_id, questionnaire, item, answer_json, answer_hash, utc, digest)
    SELECT id, participant_id, questionnaire, item, answer_json, answer_hash, utc, digest FROM questionnaire_answer ORDER BY id;
DROP TABLE questionnaire_answer;
ALTER TABLE questionnaire_answer_6 RENAME TO questionnaire_answer;

-- Each question once for each participant, or once for each of their runs.
CREATE UNIQUE INDEX questionnaire_answer_once ON questionnaire_answer (participant_id, questionnaire, item, coalesce(run_id, 0));
CREATE TRIGGER questionnaire_answer_stays BEFORE DELETE ON questionnaire_answer
    BEGIN SELECT RAISE(ABORT, 'answers are overwritten, never deleted'); END;
CREATE TRIGGER questionnaire_answer_of_run BEFORE INSERT ON questionnaire_answer
    WHEN NEW.run_id IS NOT NULL AND (SELECT participant_id FROM study_run WHERE id = NEW.run_id) IS NOT NEW.participant_id
    BEGIN SELECT RAISE(ABORT, 'an answer belongs to a run of the same participant'); END;
