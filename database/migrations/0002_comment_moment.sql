-- SPDX-License-Identifier: GPL-3.0-or-later
-- Version 2: a comment may belong to a moment of the recording (an executed tick); NULL: to the session as a whole.
-- A row without a moment keeps the digest that version 1 gave it (integrity/row_digest.h, laterColumns).
ALTER TABLE session_comment ADD COLUMN tick INTEGER CHECK (tick IS NULL OR tick >= 0);
