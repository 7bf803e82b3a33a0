-- SPDX-License-Identifier: GPL-3.0-or-later
-- A site as version 1 of the schema stored it (sqlite3's .dump): never edited; every later Chiron must open it.
CREATE TABLE meta (
    key TEXT PRIMARY KEY NOT NULL,
    value TEXT NOT NULL
) STRICT;
INSERT INTO meta VALUES('uuid','38ca1321-52ad-46e0-998e-2c5f7a51be49');
INSERT INTO meta VALUES('created_utc','2026-11-20T12:24:54.993Z');
INSERT INTO meta VALUES('demonstration','0');
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
INSERT INTO person VALUES(1,'simulated','simulated','simulated','simulated','',1,'2026-11-20T12:24:54.993Z',X'b7c60fc230f7d8f558d4581a8529a9663dfbdefb3444726b8df5f6ae6467dff6');
INSERT INTO person VALUES(2,'person','ada','ada','','admin',1,'2026-11-20T12:24:55.065Z',X'e4f20ccc41c73d2dae2b7156bdb063a99e7d095899c06eb97f32d3e4bc98fe34');
INSERT INTO person VALUES(3,'person','tim','tim','tim display','trainee',1,'2026-11-20T12:24:55.117Z',X'd122cc3a0e3a3ead12dd7ec873a06dca596e392327ea5b6ed77e074d83251a5c');
CREATE TABLE person_code (
    person_id INTEGER PRIMARY KEY REFERENCES person (id),
    code TEXT NOT NULL UNIQUE,
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;
INSERT INTO person_code VALUES(2,'P-NTT6PQBB',X'6d8c02922c9bd547d7039d9ca63d82b28a402b92545ceb774a2066a0645c3e87');
INSERT INTO person_code VALUES(3,'P-7RNQA3TT',X'd46067704ae532e11625f387a565f1ed828e2c7d54129a620ed5879f0e48d63a');
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
INSERT INTO credential VALUES(2,'$argon2id$v=19$m=8,t=1,p=1$Fk+sCblcMMj91WjieTq7Sw$1YhUXcl1+RuM8CAzLIVGUSSoS+1dzJ0eympultYmugE','$argon2id$v=19$m=8,t=1,p=1$7Q5S1hkVsHs11uEb2eXHzA$+lyS9BRVze6qkHNN1uJ4PDbuwTajRrbJBSKIgsADyeQ',0,0,'boot-a',0,X'ab7fb563c68f864e022471ae64be5f933642cf8bf6dc451e9b7528f17d33b5fe');
INSERT INTO credential VALUES(3,'$argon2id$v=19$m=8,t=1,p=1$g4bOyH07kDIDeFoXeD1z6A$m6oVVBg0/EgxVK6jnYMeoe+eLEi/evfY84vB8IHpF50','',0,0,'boot-a',0,X'9f5aa570beed2eb3e6b372f641f8a323f8b9854cc39f25cab0bbd49e03dbd7ef');
CREATE TABLE content (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    sha256 BLOB NOT NULL UNIQUE CHECK (length(sha256) = 32),
    json TEXT NOT NULL,
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;
INSERT INTO content VALUES(1,X'a449996128d941f7e92652cf69aca7fc01d4eb6558962b50a4edce053911cda1','{"K_N_per_m":1000,"level":2}',X'320abc4acb47ed2d0d41b7333b73d792aa2ae620fcdb3f82fae2ea97b44e4109');
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
INSERT INTO session VALUES(1,3,'sphere_apex',2,1,-81985529216486896,'novice',1,'{"driver":"simulated"}','{"scale":1}','{"cap_N":4}','{"models":"1"}','build','cpu',4.0,10,0,0,0,'',X'010203','2026-11-20T12:24:55.161Z',0,'completed','2026-11-20T12:24:55.162Z',1000,1000,0,2,1400,'{}',X'6bd5acbce1c2595cc2e4043f7cd46e8d6a3d4b1c167ed3d5f68517e1ebc23519',0,0,'',NULL,NULL,NULL,X'5ed41b7e09140d0d6ff86c60d1da80b73c3dc1512ab7268369ed77eef1b8a522');
INSERT INTO session VALUES(2,1,'sphere_apex',2,1,-81985529216486896,'novice',1,'{"driver":"simulated"}','{"scale":1}','{"cap_N":4}','{"models":"1"}','build','cpu',4.0,10,0,0,0,'',X'010203','2026-11-20T12:24:55.209Z',0,'voided','2026-11-20T12:24:55.210Z',1000,1000,0,1,700,'{}',X'df6fc82e59beda82ba9ce1c6ab72ea696f0a2c8b00d453b8f9a2a09abca6a907',0,0,'the chair fell over',X'0543d3d4d32cfbb11975ad7aa1802682ac2caee834d31db3081f18860ef720ac',2,'completed',X'3799fc257719e270e32b52140690271ff408c06842e5c52dfd91d13cac10d936');
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
INSERT INTO trial VALUES(1,0,0,'completed',0,999,0,0,'{"R_m":0.02}',X'9cbe9ca6b731efa242c33297164c6c42d6881a077c9cb3a0050e265c8426a00c');
INSERT INTO trial VALUES(2,0,0,'completed',0,999,0,0,'{"R_m":0.02}',X'741598bdb02ecab3b75d1cf5b6442ac3d3e1c8cd1405bf048d179aebf2f5d363');
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
INSERT INTO chunk VALUES(1,1,0,0,250,X'001f3e5d7c9bbad9f91637547592b3d0f20d2c4f6e89a8cbeb0425466780a1c2e4fb1a39587f9ebdddf21330517697b4d6e9082b4a6d8cafcfe00122436485a6c8d7f61534537291b1deff1c3d5a7b98bac5e40726416083a3cced0e2f48698aacb3d2f11037567595badbf8193e5f7c9ea1c0e30225446787a8c9ea0b2c4d6e908faecdec0b2a496986a7c4e5022340629dbcdffe19385b7b94b5d6f7103152746b8aa9c8ef0e2d4d6283a0c1e60724467998bbdafd1c3f5f7091b2d3f4153658476685a4c3e201214e6f8cadcaeb082a557497b6d1f013335c7d9ebfd8f91a3c23426180a7c6e5052a4b6889aecfec0e31507392b5d4f71738597a9bbcddfe203f1e7d5cbb9af9d936177455b293f0d22d0c6f4ea988ebcb24056647a081e2c4db3a19785fbe9dfdd233107156b794f6c9280b6a4dac8fefc021026344a586e8f7d635147352b191fedf3c1d7a5bb89ae5c427066140a383eccd2e0f6849aa8c93f2d130177655b59afbd8391e7f5cbe81e0c322056447a788e9ca2b0c6d4eb0af8eedcc2b0a6949a687e4c522036042bd9cffde39187b5bb495f6d7301172544baa89e8cf2e0d6d42a380e1c627046659b89bfadd3c1f7f50b192f3d43516786746a584e3c221016e4fac8deacb280a7554b796f1d033137c5dbe9ff8d93a1c036241a087e6c5250a6b48a98eefcc2e117053b295f4d73718795abb9cfdde405f7e1d3cdbfa99b956771435d2f390b24d6c0f2ec9e88bab44650627c0e182a4bb5a79183fdefd9db253701136d7f496a9486b0a2dccef8fa041620324c5e68897b655741332d1f19ebf5c7d1a3bd8fa85a447660120c3e38cad4e6f0829caecf392b150771635d5fa9bb8597e1f3cdee180a342650427c7e889aa4b6c0d2ed0cfee8dac4b6a0929c6e784a542630022ddfc9fbe59781b3bd4f596b7507112342bcae988af4e6d0d22c3e081a647640639d8fb9abd5c7f1f30d1f2',X'fcfb07b056bcf530e6a435d0c5dc74276fe2c30f9013c94771ff2f8797a71719',X'0101010101010101010101010101010101010101010101010101010101010101',X'6565656565656565656565656565656565656565656565656565656565656565',X'69070cecaef67cee599731cda0747d29d032cda02fd0525ce5ec937420ebcb99');
INSERT INTO chunk VALUES(2,1,1,250,250,X'0726456483a2c1e0fe1f3c5d7a9bb8d9f51437567190b3d2ec0d2e4f6889aacbe30221406786a5c4dafb18395e7f9cbdd1f01332557497b6c8e90a2b4c6d8eafcfee0d2c4b6a89a8b6d7f41532537091bddcff1e39587b9aa4c5e60720416283abcae9082f4e6d8c92b3d0f11637547599b8dbfa1d3c5f7e80a1c2e30425466797b6d5f4133251706e8faccdea0b28496584a7c6e10023427c9dbedff8193a5b7392b1d0f71635544a6b88a9ceef0c2d416083a2c5e4072658799abbdcfd1e3f5f7e9dbcdbfa193826476485a2c3e0012d4c6f8ea9c8eb0a34557697b0d1f2133b5a7998bfdefd1c0223406186a7c4e509284b6a8daccfee1031527394b5d6f727066544a382e1c0de3f1c7d5abb98f9d534177651b093f2cc2d0e6f48a98aebc322016047a685e4fadb38197e5fbc9df1d033127554b796e8c92a0b6c4dae8fefce2d0c6b4aa98896f7d435127350b19dfcdf3e19785bba84e5c627006142a38beac9280f6e4dacb293f0d136177455b998fbda3d1c7f5ea081e2c324056647b796f5d4331271504eaf8cedca2b086945a487e6c12003625cbd9effd8391a7b53b291f0d73615746a4ba889eecf2c0d6140a382e5c427067859ba9bfcdd3e1f7f5ebd9cfbda3918066744a582e3c0210d6c4fae89e8cb2a147556b790f1d2331b7a59b89ffedd3c22036041a687e4c529086b4aad8cefce30117253b495f6d747660524c3e281a0be5f7c1d3adbf899b554771631d0f392ac4d6e0f28c9ea8ba342610027c6e5849abb58791e3fdcfd91b053721534d7f688a94a6b0c2dceef8fae4d6c0b2ac9e8f697b455721330d1fd9cbf5e79183bdae485a647600122c3eb8aa9486f0e2dccd2f390b156771435d9f89bba5d7c1f3ec0e182a344650627d7f695b4537211302ecfec8daa4b680925c4e786a14063023cddfe9fb8597a1b33d2f190b75675140a2bc8e98eaf4c6d0120c3e285a447661839dafb',X'df27e8766fe89740d1d62efff2bb5e405ad72cdb38e2ffb5d5d9e99e9b244432',X'0202020202020202020202020202020202020202020202020202020202020202',X'6666666666666666666666666666666666666666666666666666666666666666',X'ae23ee5c8d07c66ee881724d0fc05fd5a0efb46dc01a6056f7a1d09daa0b042b');
INSERT INTO chunk VALUES(3,2,0,0,250,X'001f3e5d7c9bbad9f91637547592b3d0f20d2c4f6e89a8cbeb0425466780a1c2e4fb1a39587f9ebdddf21330517697b4d6e9082b4a6d8cafcfe00122436485a6c8d7f61534537291b1deff1c3d5a7b98bac5e40726416083a3cced0e2f48698aacb3d2f11037567595badbf8193e5f7c9ea1c0e30225446787a8c9ea0b2c4d6e908faecdec0b2a496986a7c4e5022340629dbcdffe19385b7b94b5d6f7103152746b8aa9c8ef0e2d4d6283a0c1e60724467998bbdafd1c3f5f7091b2d3f4153658476685a4c3e201214e6f8cadcaeb082a557497b6d1f013335c7d9ebfd8f91a3c23426180a7c6e5052a4b6889aecfec0e31507392b5d4f71738597a9bbcddfe203f1e7d5cbb9af9d936177455b293f0d22d0c6f4ea988ebcb24056647a081e2c4db3a19785fbe9dfdd233107156b794f6c9280b6a4dac8fefc021026344a586e8f7d635147352b191fedf3c1d7a5bb89ae5c427066140a383eccd2e0f6849aa8c93f2d130177655b59afbd8391e7f5cbe81e0c322056447a788e9ca2b0c6d4eb0af8eedcc2b0a6949a687e4c522036042bd9cffde39187b5bb495f6d7301172544baa89e8cf2e0d6d42a380e1c627046659b89bfadd3c1f7f50b192f3d43516786746a584e3c221016e4fac8deacb280a7554b796f1d033137c5dbe9ff8d93a1c036241a087e6c5250a6b48a98eefcc2e117053b295f4d73718795abb9cfdde405f7e1d3cdbfa99b956771435d2f390b24d6c0f2ec9e88bab44650627c0e182a4bb5a79183fdefd9db253701136d7f496a9486b0a2dccef8fa041620324c5e68897b655741332d1f19ebf5c7d1a3bd8fa85a447660120c3e38cad4e6f0829caecf392b150771635d5fa9bb8597e1f3cdee180a342650427c7e889aa4b6c0d2ed0cfee8dac4b6a0929c6e784a542630022ddfc9fbe59781b3bd4f596b7507112342bcae988af4e6d0d22c3e081a647640639d8fb9abd5c7f1f30d1f2',X'fcfb07b056bcf530e6a435d0c5dc74276fe2c30f9013c94771ff2f8797a71719',X'0101010101010101010101010101010101010101010101010101010101010101',X'6565656565656565656565656565656565656565656565656565656565656565',X'31b55855231bb4bcaa5f4946423d12d65ba3b95499acdcc34b0ced471dc5ff1f');
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
INSERT INTO second_summary VALUES(1,0,0,250,0.010000000000000000208,1.5,0.5,0.25,0.0,3,X'91cb42dd0a2506ebfb759d4c2840447016ad5c5316e4ec0de6e0eeb037c0db3e');
INSERT INTO second_summary VALUES(1,1,0,250,0.010000000000000000208,1.5,0.5,0.25,0.0,3,X'a542150ebda72bfab53db5930336455fc65d8e424394dcd29aa0b3bdda1887c6');
INSERT INTO second_summary VALUES(2,0,0,250,0.010000000000000000208,1.5,0.5,0.25,0.0,3,X'6bf64e70b79fd277ab46bcbaf0485702022f2d2a944ac0ccba30f75ea2ba918d');
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
INSERT INTO event VALUES(1,0,17,0.017000000000000001221,0,'marked','{}',X'aaf0ba76508c236cc3287b98b93b7244b102e11a31d9f6c80726e3eb6329e80c');
INSERT INTO event VALUES(2,0,17,0.017000000000000001221,0,'marked','{}',X'25b30da8aa7ddde450d1f1f2c2314a2daf5c24c3affbc977011a5b305e3f5e9d');
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
INSERT INTO score_set VALUES(1,1,1,'2026-11-20T12:24:55.189Z',1,2,4,X'77e85cf4b6a6587b7a5914e1f053f2cce0cb05e24469d70c3acda430ea5c04b8',X'40a71046f3af68872ffe481e63639aabccaa8175340398f615eff47409da7ac3');
INSERT INTO score_set VALUES(2,2,1,'2026-11-20T12:24:55.229Z',1,2,4,X'b31d3c4dd5db0ab5b9a383d7f27617326c8db97bd3b562dbb3349b546432a840',X'f1bfb3e4698ac89b31f2de8d72006a6298c860d12b33671aaf6b1437a6564413');
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
INSERT INTO score VALUES(1,-1,0,'path_length',1,'m',0.3000000000000000444,'',1,X'd3dc33a543800a8bc323909544b42cbb6a9dc6357e9e561452f2853e97bc75ef');
INSERT INTO score VALUES(1,-1,1,'sparc',2,'',NULL,'too short',NULL,X'80dbe15a259977b9c747f4222d3c4b8211cffd8fd12dc7bc58fb70643b8124a5');
INSERT INTO score VALUES(1,0,0,'path_length',1,'m',0.10000000000000000555,'',NULL,X'5e6d673fc4c790d2f74ed97c7ad1fed3c7f00cebb8e7203e6c8c6d624539c1a0');
INSERT INTO score VALUES(1,1,0,'path_length',1,'m',1.000000000000000025e-300,'',NULL,X'2e99e4888e7463a7ad7f1a48e00564b7686b502cddfcda891e57ae96ac81b85c');
INSERT INTO score VALUES(2,-1,0,'path_length',1,'m',0.3000000000000000444,'',1,X'8d5f29109a3662d72300cdd48fa34a2bc9dc8367df066f352ff47487bec227a0');
INSERT INTO score VALUES(2,-1,1,'sparc',2,'',NULL,'too short',NULL,X'd7856b07c9f089aea83c852ff314d025a809168fe8adc4ad80032533c6084262');
INSERT INTO score VALUES(2,0,0,'path_length',1,'m',0.10000000000000000555,'',NULL,X'821948188e39e8180d813c06c13239798af6cd15ada7f6326fa5cabf9091a521');
INSERT INTO score VALUES(2,1,0,'path_length',1,'m',1.000000000000000025e-300,'',NULL,X'16456474fb671ebe2842c3653dc5f9ac497faec3228dbed63a207590a25ece58');
CREATE TABLE session_comment (
    id INTEGER PRIMARY KEY CHECK (id > 0),
    session_id INTEGER NOT NULL REFERENCES session (id),
    author_id INTEGER NOT NULL REFERENCES person (id),
    utc TEXT NOT NULL,
    text TEXT NOT NULL,
    text_hash BLOB NOT NULL CHECK (length(text_hash) = 32),
    digest BLOB NOT NULL CHECK (length(digest) = 32)
) STRICT;
INSERT INTO session_comment VALUES(1,1,2,'2026-11-20T12:24:55.257Z','steady',X'6b1c9f6cf5b275591690243da5b24b41f96a08dc63f8e940ae1425cc46f00fe0',X'405003d46af2721448b0cb8e69100e60f1945887e81311e133b2059720aee43a');
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
INSERT INTO audit VALUES(1,'2026-11-20T12:24:54.993Z','maintenance',0,'create','person',1,'{"row":"b7c60fc230f7d8f558d4581a8529a9663dfbdefb3444726b8df5f6ae6467dff6"}',X'5566735ad0ab45da65ee2e934d818e17935ea6728633a887e4348eeb0e34589e',X'56d949eb06c46b16435826e97f96e46cb8d45f1f7f1dcd9d07ab509a7212326a');
INSERT INTO audit VALUES(2,'2026-11-20T12:24:55.065Z','anonymous',0,'createPerson','person',2,'{"roles":"admin","row":"e4f20ccc41c73d2dae2b7156bdb063a99e7d095899c06eb97f32d3e4bc98fe34"}',X'56d949eb06c46b16435826e97f96e46cb8d45f1f7f1dcd9d07ab509a7212326a',X'dbd69ced183300473bd73c4ff47a2ea023386bcbacdfc268997b2374f341d826');
INSERT INTO audit VALUES(3,'2026-11-20T12:24:55.104Z','person',2,'login','person',2,'{"wrong_before":0}',X'dbd69ced183300473bd73c4ff47a2ea023386bcbacdfc268997b2374f341d826',X'bafeedf7e5939e0e34272ae12a8a68c5c22d59049feaf351c1caf285eaad8953');
INSERT INTO audit VALUES(4,'2026-11-20T12:24:55.117Z','person',2,'createPerson','person',3,'{"roles":"trainee","row":"d122cc3a0e3a3ead12dd7ec873a06dca596e392327ea5b6ed77e074d83251a5c"}',X'bafeedf7e5939e0e34272ae12a8a68c5c22d59049feaf351c1caf285eaad8953',X'4c6f78c8f2617dbb5def621e4b8c2e39f43f80f3405485c8be8784fe19752840');
INSERT INTO audit VALUES(5,'2026-11-20T12:24:55.141Z','person',3,'login','person',3,'{"wrong_before":0}',X'4c6f78c8f2617dbb5def621e4b8c2e39f43f80f3405485c8be8784fe19752840',X'24741d392cf317228297eb84ff0340e6d5c52f131429238cdf16dc329a38dc1d');
INSERT INTO audit VALUES(6,'2026-11-20T12:24:55.161Z','person',3,'beginSession','session',1,'{"row":"6942b25649167f175630d6447134e2079f1e630ff0b91fc65ab7a6055776d3a4"}',X'24741d392cf317228297eb84ff0340e6d5c52f131429238cdf16dc329a38dc1d',X'a022585494ee200dbdd709a01730ce8b9bf2ae6ec9dba8ea534f0d4e64fb16a5');
INSERT INTO audit VALUES(7,'2026-11-20T12:24:55.162Z','person',3,'finishSession','session',1,'{"seal":"6bd5acbce1c2595cc2e4043f7cd46e8d6a3d4b1c167ed3d5f68517e1ebc23519","state":"completed","row":"5ed41b7e09140d0d6ff86c60d1da80b73c3dc1512ab7268369ed77eef1b8a522"}',X'a022585494ee200dbdd709a01730ce8b9bf2ae6ec9dba8ea534f0d4e64fb16a5',X'd8ece2028842f33097932d57284073216f801707c21ae8c42bbda5f3ec8ebdb6');
INSERT INTO audit VALUES(8,'2026-11-20T12:24:55.189Z','person',3,'storeScores','score_set',1,'{"session":1,"row":"40a71046f3af68872ffe481e63639aabccaa8175340398f615eff47409da7ac3"}',X'd8ece2028842f33097932d57284073216f801707c21ae8c42bbda5f3ec8ebdb6',X'ef8aafd92c4fb65071b6658d9e1850fcd6c6e042200853e7447c8062675428e2');
INSERT INTO audit VALUES(9,'2026-11-20T12:24:55.209Z','simulated',1,'beginSession','session',2,'{"row":"0c6dc4356d2f6aaf41fc3faa33608f01df457f4fbea60a46d71e01908bb45366"}',X'ef8aafd92c4fb65071b6658d9e1850fcd6c6e042200853e7447c8062675428e2',X'267c72d2ca4897aef422e012adaa98406f34d0781134ad49a26ad38467c0d6b6');
INSERT INTO audit VALUES(10,'2026-11-20T12:24:55.210Z','simulated',1,'finishSession','session',2,'{"seal":"df6fc82e59beda82ba9ce1c6ab72ea696f0a2c8b00d453b8f9a2a09abca6a907","state":"completed","row":"66c95a208ac91909fb13523a2bd0769779775c1fb472793a033aa18e38d30090"}',X'267c72d2ca4897aef422e012adaa98406f34d0781134ad49a26ad38467c0d6b6',X'8a2806bffb48ca0ee6aaa68b06c9af0d73815275131318a700d989ab5f1bbbad');
INSERT INTO audit VALUES(11,'2026-11-20T12:24:55.229Z','simulated',1,'storeScores','score_set',2,'{"session":2,"row":"f1bfb3e4698ac89b31f2de8d72006a6298c860d12b33671aaf6b1437a6564413"}',X'8a2806bffb48ca0ee6aaa68b06c9af0d73815275131318a700d989ab5f1bbbad',X'ca4b6aaa1dd1a4ff695d2b85ecbd991a6d424ee1321652ac72d8b499feca0f95');
INSERT INTO audit VALUES(12,'2026-11-20T12:24:55.245Z','person',2,'voidSession','session',2,'{"row":"3799fc257719e270e32b52140690271ff408c06842e5c52dfd91d13cac10d936"}',X'ca4b6aaa1dd1a4ff695d2b85ecbd991a6d424ee1321652ac72d8b499feca0f95',X'2c6cfebdabfd05d56a612c1f7995604f9d4a2717e7aa70dd063aef2766f10ca4');
INSERT INTO audit VALUES(13,'2026-11-20T12:24:55.257Z','person',2,'addComment','session_comment',1,'{"row":"405003d46af2721448b0cb8e69100e60f1945887e81311e133b2059720aee43a"}',X'2c6cfebdabfd05d56a612c1f7995604f9d4a2717e7aa70dd063aef2766f10ca4',X'035d93b93efd3f1f57c50f99743552a8687ffd509dfa4b95a60e9cc650ea350d');
CREATE INDEX session_by_person ON session (person_id, id);
CREATE INDEX session_by_exercise ON session (exercise, level, id);
CREATE INDEX session_by_state ON session (state, id);
CREATE INDEX session_comment_by_session ON session_comment (session_id, id);
CREATE INDEX session_comment_by_author ON session_comment (author_id, id);
CREATE INDEX audit_by_target ON audit (target, target_id, sequence);
CREATE INDEX audit_by_actor ON audit (actor_id, sequence);
CREATE TRIGGER person_stays BEFORE DELETE ON person BEGIN SELECT RAISE(ABORT, 'people are never deleted'); END;
CREATE TRIGGER session_stays BEFORE DELETE ON session BEGIN SELECT RAISE(ABORT, 'sessions are never deleted'); END;
CREATE TRIGGER trial_stays BEFORE DELETE ON trial BEGIN SELECT RAISE(ABORT, 'trials are never deleted'); END;
CREATE TRIGGER chunk_stays BEFORE DELETE ON chunk BEGIN SELECT RAISE(ABORT, 'chunks are never deleted'); END;
CREATE TRIGGER score_stays BEFORE DELETE ON score BEGIN SELECT RAISE(ABORT, 'scores are never deleted'); END;
CREATE TRIGGER score_fixed BEFORE UPDATE ON score BEGIN SELECT RAISE(ABORT, 'scores are never changed'); END;
CREATE TRIGGER audit_stays BEFORE DELETE ON audit BEGIN SELECT RAISE(ABORT, 'the audit is never deleted'); END;
CREATE TRIGGER audit_fixed BEFORE UPDATE ON audit BEGIN SELECT RAISE(ABORT, 'the audit is never changed'); END;
