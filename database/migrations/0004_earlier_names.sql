-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 4: what people were called before. The audit chain holds no names, so that an erasure need not touch it; it vouches for these
-- rows instead. Names are kept as JSON with a random nonce in it and covered through their hash; empty once the person is erased.

CREATE TABLE person_name (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    person_id INTEGER NOT NULL REFERENCES person (id),
    until_utc TEXT NOT NULL,
    changed_by INTEGER NOT NULL REFERENCES person (id),
    names_json TEXT NOT NULL,
    names_hash BLOB NOT NULL CHECK (length(names_hash) = 32),
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;
CREATE INDEX person_name_by_person ON person_name (person_id, id);
CREATE TRIGGER person_name_stays BEFORE DELETE ON person_name BEGIN SELECT RAISE(ABORT, 'earlier names are never deleted'); END;
