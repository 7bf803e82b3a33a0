<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="el" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>About Chiron</source>
        <translation>Σχετικά με το Chiron</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Έκδοση %1</translation>
    </message>
    <message>
        <source>Training for the sense of touch in minimally invasive surgery. Named after the centaur who taught Asclepius medicine; his name comes from cheir, hand.</source>
        <translation>Εκπαίδευση της αφής στην ελάχιστα επεμβατική χειρουργική. Πήρε το όνομά του από τον Κένταυρο Χείρωνα, που δίδαξε την ιατρική στον Ασκληπιό· το όνομα προέρχεται από τη λέξη χειρ, χέρι.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. Not a medical device.</source>
        <translation>Ελεύθερο λογισμικό με την άδεια GNU General Public License, έκδοση 3 ή νεότερη. Δεν είναι ιατροτεχνολογικό προϊόν.</translation>
    </message>
    <message>
        <source>Build: %1</source>
        <translation>Έκδοση κώδικα: %1</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Κλείσιμο</translation>
    </message>
</context>
<context>
    <name>AccountForm</name>
    <message>
        <source>Language</source>
        <translation>Γλώσσα</translation>
    </message>
</context>
<context>
    <name>AccountWords</name>
    <message>
        <source>Too many wrong attempts. This account is locked for a moment; nothing is lost.</source>
        <translation>Πάρα πολλές λανθασμένες προσπάθειες. Ο λογαριασμός κλειδώθηκε για λίγο· δεν χάνεται τίποτα.</translation>
    </message>
    <message>
        <source>This account is disabled. What was recorded is kept; an administrator can enable the account again.</source>
        <translation>Αυτός ο λογαριασμός είναι απενεργοποιημένος. Όσα έχουν καταγραφεί διατηρούνται· ένας διαχειριστής μπορεί να τον ενεργοποιήσει ξανά.</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>Εκπαιδευόμενος/-η</translation>
    </message>
    <message>
        <source>Trainer</source>
        <translation>Εκπαιδευτής/-τρια</translation>
    </message>
    <message>
        <source>Researcher</source>
        <translation>Ερευνητής/-τρια</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>Διαχειριστής/-τρια</translation>
    </message>
    <message>
        <source>Wrong name or password. Passwords are case-sensitive; check Caps Lock.</source>
        <translation>Λάθος όνομα ή κωδικός πρόσβασης. Τα κεφαλαία διαφέρουν από τα πεζά· ελέγξτε το Caps Lock.</translation>
    </message>
    <message>
        <source>Wrong name or recovery code. The code has five groups of five letters and digits.</source>
        <translation>Λάθος όνομα ή κωδικός ανάκτησης. Ο κωδικός έχει πέντε ομάδες των πέντε γραμμάτων και ψηφίων.</translation>
    </message>
    <message numerus="yes">
        <source>Try again in %n second(s)</source>
        <translation>
            <numerusform>Νέα προσπάθεια σε %n δευτερόλεπτο</numerusform>
            <numerusform>Νέα προσπάθεια σε %n δευτερόλεπτα</numerusform>
        </translation>
    </message>
    <message>
        <source>Wrong password. Passwords are case-sensitive.</source>
        <translation>Λάθος κωδικός πρόσβασης. Τα κεφαλαία διαφέρουν από τα πεζά.</translation>
    </message>
    <message>
        <source>Wrong name or password; check Caps Lock. Ask an administrator; your login name may have changed.</source>
        <translation>Λάθος όνομα ή κωδικός πρόσβασης· ελέγξτε το Caps Lock. Ρωτήστε έναν διαχειριστή· το όνομα χρήστη σας μπορεί να έχει αλλάξει.</translation>
    </message>
</context>
<context>
    <name>Advice</name>
    <message>
        <source>in trial %1</source>
        <translation>στη δοκιμή %1</translation>
    </message>
    <message>
        <source>in trial %1, %2 after it began</source>
        <translation>στη δοκιμή %1, %2 μετά την έναρξή της</translation>
    </message>
    <message>
        <source>%1 after the start</source>
        <translation>%1 μετά την έναρξη</translation>
    </message>
    <message>
        <source>at a depth of %1, %2</source>
        <translation>σε βάθος %1, %2</translation>
    </message>
    <message>
        <source>It was worst %1: %2.</source>
        <translation>Το χειρότερο ήταν %1: %2.</translation>
    </message>
    <message>
        <source>It was worst %1.</source>
        <translation>Το χειρότερο ήταν %1.</translation>
    </message>
</context>
<context>
    <name>AnswerNote</name>
    <message>
        <source>Marked</source>
        <translation>Σημειώθηκε</translation>
    </message>
    <message>
        <source>%1 mm from the top: not on the sphere</source>
        <translation>%1 mm από την κορυφή: όχι πάνω στη σφαίρα</translation>
    </message>
    <message>
        <source>%1 mm from the top</source>
        <translation>%1 mm από την κορυφή</translation>
    </message>
    <message>
        <source>Time is up</source>
        <translation>Ο χρόνος τελείωσε</translation>
    </message>
    <message>
        <source>This trial can no longer be completed</source>
        <translation>Αυτή η δοκιμή δεν μπορεί πια να ολοκληρωθεί</translation>
    </message>
    <message>
        <source>Trial completed</source>
        <translation>Η δοκιμή ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>Right: there was no lump</source>
        <translation>Σωστά: δεν υπήρχε όζος</translation>
    </message>
    <message>
        <source>There was no lump</source>
        <translation>Δεν υπήρχε όζος</translation>
    </message>
    <message>
        <source>%1 of %2 lumps found</source>
        <translation>Βρέθηκαν %1 από τους %2 όζους</translation>
    </message>
    <message>
        <source>The lump was missed</source>
        <translation>Ο όζος διέφυγε</translation>
    </message>
    <message>
        <source>Lump found, %1 mm off</source>
        <translation>Ο όζος βρέθηκε, με απόκλιση %1 mm</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n false alarm(s)</source>
        <translation>
            <numerusform>%n ψευδής συναγερμός</numerusform>
            <numerusform>%n ψευδείς συναγερμοί</numerusform>
        </translation>
    </message>
    <message>
        <source>Too much: the tissue was damaged</source>
        <translation>Υπερβολικά: ο ιστός υπέστη βλάβη</translation>
    </message>
    <message>
        <source>It slipped: hold it a little more firmly</source>
        <translation>Γλίστρησε: κρατήστε λίγο πιο σφιχτά</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Not counted: mark while you touch the sphere</source>
        <translation>Δεν μετράει: σημειώστε ενώ αγγίζετε τη σφαίρα</translation>
    </message>
    <message>
        <source>Too hard: the tissue gave way. Draw back until you are out of it</source>
        <translation>Πολύ δυνατά: ο ιστός υποχώρησε. Αποσυρθείτε μέχρι να βγείτε από αυτόν</translation>
    </message>
    <message>
        <source>The tissue gave way</source>
        <translation>Ο ιστός υποχώρησε</translation>
    </message>
    <message>
        <source>The tissue gave way: this trial can no longer be completed</source>
        <translation>Ο ιστός υποχώρησε: αυτή η δοκιμή δεν μπορεί πια να ολοκληρωθεί</translation>
    </message>
    <message>
        <source>The tube tore: this trial can no longer be completed. Stretch it less far, and pull more gently</source>
        <translation>Ο σωλήνας σχίστηκε: αυτή η δοκιμή δεν μπορεί πια να ολοκληρωθεί. Τεντώστε τον λιγότερο και τραβήξτε πιο απαλά</translation>
    </message>
    <message>
        <source>The tube tore: this trial can no longer be completed</source>
        <translation>Ο σωλήνας σχίστηκε: αυτή η δοκιμή δεν μπορεί πια να ολοκληρωθεί</translation>
    </message>
    <message>
        <source>Too hard: the tissue gave way. Draw back until you are out of it, or open the jaws if they squeezed it</source>
        <translation>Πολύ δυνατά: ο ιστός υποχώρησε. Αποσυρθείτε μέχρι να βγείτε από αυτόν, ή ανοίξτε τις σιαγόνες αν τον συνέσφιξαν</translation>
    </message>
    <message>
        <source>The object came off the tool</source>
        <translation>Το αντικείμενο ξέφυγε από το εργαλείο</translation>
    </message>
    <message>
        <source>%1 mm from the middle of the ring</source>
        <translation>%1 mm από το κέντρο του δακτυλίου</translation>
    </message>
</context>
<context>
    <name>AskedSitting</name>
    <message>
        <source>The study %1 could not be opened.</source>
        <translation>Δεν ήταν δυνατό το άνοιγμα της μελέτης %1.</translation>
    </message>
</context>
<context>
    <name>CheckRecord</name>
    <message>
        <source>Page %1 of %2</source>
        <translation>Σελίδα %1 από %2</translation>
    </message>
</context>
<context>
    <name>CommandWords</name>
    <message>
        <source>start page, dashboard, begin, what next, news</source>
        <translation>αρχική σελίδα, πίνακας, έναρξη, νέα, τι ακολουθεί</translation>
    </message>
    <message>
        <source>experiment, research, trial, participants, questionnaire</source>
        <translation>πείραμα, έρευνα, συμμετέχοντες, ερωτηματολόγιο</translation>
    </message>
    <message>
        <source>analysis, statistics, export</source>
        <translation>ανάλυση, στατιστικά, εξαγωγή</translation>
    </message>
    <message>
        <source>group, class, course, cohort, overview, results, trainees, students, learners, passed, due, who has trained</source>
        <translation>ομάδα, τάξη, μάθημα, επισκόπηση, σύνοψη, αποτελέσματα, εκπαιδευόμενοι, φοιτητές, επιτυχία, προθεσμία, ποιος εκπαιδεύτηκε</translation>
    </message>
    <message>
        <source>users, accounts, group, class, roster, trainees, students, names, passwords, roles, add a user</source>
        <translation>χρήστες, λογαριασμοί, ομάδα, τάξη, κατάλογος, εκπαιδευόμενοι, φοιτητές, ονόματα, κωδικοί πρόσβασης, ρόλοι, νέος χρήστης</translation>
    </message>
    <message>
        <source>backup, back up, copy, restore, disk, space, database, verify, save</source>
        <translation>αντίγραφο ασφαλείας, επαναφορά, δίσκος, χώρος, βάση δεδομένων, έλεγχος, αποθήκευση</translation>
    </message>
    <message>
        <source>device, haptic, hardware, calibration, check, timing, computer, test</source>
        <translation>συσκευή, απτικός, υλικό, βαθμονόμηση, έλεγχος, χρονισμός, υπολογιστής</translation>
    </message>
    <message>
        <source>progress, scores, marks, grades, curve, history, overview, review, export my data</source>
        <translation>πρόοδος, βαθμολογίες, βαθμοί, καμπύλη, ιστορικό, επισκόπηση, εξαγωγή των δεδομένων μου</translation>
    </message>
    <message>
        <source>options, preferences, language, theme, dark mode, text size, sound, volume</source>
        <translation>επιλογές, προτιμήσεις, γλώσσα, χρώματα, σκούρο θέμα, μέγεθος κειμένου, ήχος, ένταση</translation>
    </message>
    <message>
        <source>assess, feedback, look at, mark, grade, inbox, to do</source>
        <translation>αξιολόγηση, ανατροφοδότηση, βαθμολόγηση, σχολιασμός, εισερχόμενα, εκκρεμότητες</translation>
    </message>
    <message>
        <source>feedback, notes, remarks, messages, answers, replies, review</source>
        <translation>ανατροφοδότηση, σημειώσεις, παρατηρήσεις, μηνύματα, απαντήσεις, αξιολόγηση</translation>
    </message>
    <message>
        <source>switch user, logout, log off, sign out, change user, leave</source>
        <translation>αλλαγή χρήστη, έξοδος χρήστη, logout</translation>
    </message>
    <message>
        <source>password, profile, name, recovery code</source>
        <translation>κωδικός πρόσβασης, προφίλ, όνομα, κωδικός ανάκτησης</translation>
    </message>
    <message>
        <source>quit, exit, end the program, shut down</source>
        <translation>τερματισμός, έξοδος, τέλος προγράμματος</translation>
    </message>
    <message>
        <source>manual, guide, how do I, what is this</source>
        <translation>εγχειρίδιο, οδηγός, πώς γίνεται, τι είναι αυτό</translation>
    </message>
    <message>
        <source>keys, hotkeys</source>
        <translation>πλήκτρα, συντομεύσεις</translation>
    </message>
    <message>
        <source>pause, away, screen lock</source>
        <translation>παύση, απουσία, κλείδωμα οθόνης</translation>
    </message>
    <message>
        <source>train, practise, practice, task, lesson, level, choose an exercise, curriculum</source>
        <translation>εκπαίδευση, εξάσκηση, προπόνηση, μάθημα, επίπεδο, επιλογή άσκησης</translation>
    </message>
    <message>
        <source>recordings, attempts, history, list, playback, debrief</source>
        <translation>καταγραφές, προσπάθειες, ιστορικό, λίστα, αναπαραγωγή, απολογισμός</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Go to: %1</source>
        <translation>Μετάβαση: %1</translation>
    </message>
    <message>
        <source>Colours: light</source>
        <translation>Χρώματα: ανοιχτά</translation>
    </message>
    <message>
        <source>Colours: dark</source>
        <translation>Χρώματα: σκούρα</translation>
    </message>
    <message>
        <source>Colours: high contrast</source>
        <translation>Χρώματα: υψηλή αντίθεση</translation>
    </message>
    <message>
        <source>Larger text and controls</source>
        <translation>Μεγαλύτερο κείμενο και κουμπιά</translation>
    </message>
    <message>
        <source>Smaller text and controls</source>
        <translation>Μικρότερο κείμενο και κουμπιά</translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation>Γλώσσα: %1</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Εύρεση εντολής</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Συντομεύσεις πληκτρολογίου</translation>
    </message>
    <message>
        <source>Help for this screen</source>
        <translation>Βοήθεια για αυτή την οθόνη</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Πίσω</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Κλείδωμα</translation>
    </message>
    <message>
        <source>Close Chiron</source>
        <translation>Κλείσιμο του Chiron</translation>
    </message>
    <message>
        <source>Screens</source>
        <translation>Οθόνες</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Πρόγραμμα</translation>
    </message>
    <message>
        <source>About Chiron</source>
        <translation>Σχετικά με το Chiron</translation>
    </message>
    <message>
        <source>My account</source>
        <translation>Ο λογαριασμός μου</translation>
    </message>
    <message>
        <source>Log out</source>
        <translation>Αποσύνδεση</translation>
    </message>
    <message>
        <source>Sessions to review</source>
        <translation>Συνεδρίες προς αξιολόγηση</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Σχόλια</translation>
    </message>
</context>
<context>
    <name>ControlGuide</name>
    <message>
        <source>Advance</source>
        <translation>Προώθηση</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Στροφή</translation>
    </message>
    <message>
        <source>Move the mouse, or use the arrow keys.</source>
        <translation>Μετακινήστε το ποντίκι ή χρησιμοποιήστε τα βέλη.</translation>
    </message>
    <message>
        <source>Shift sideways</source>
        <translation>Πλάγια μετακίνηση</translation>
    </message>
    <message>
        <source>Move the mouse with the right button or Shift held.</source>
        <translation>Μετακινήστε το ποντίκι με πατημένο το δεξί κουμπί ή το Shift.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Μετακίνηση</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Κατέβασμα</translation>
    </message>
    <message>
        <source>Close the jaw</source>
        <translation>Κλείσιμο σιαγόνων</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Πίεση</translation>
    </message>
    <message>
        <source>Mark a finding</source>
        <translation>Σημείωση ευρήματος</translation>
    </message>
    <message>
        <source>Click, or press Enter. When nothing is left to report, press D.</source>
        <translation>Κάντε κλικ ή πατήστε Enter. Όταν δεν μένει τίποτα για αναφορά, πατήστε D.</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Σημείωση</translation>
    </message>
    <message>
        <source>Click, or press Enter, while you touch the place.</source>
        <translation>Κάντε κλικ ή πατήστε Enter ενώ αγγίζετε το σημείο.</translation>
    </message>
    <message>
        <source>Roll the wheel away from you, or hold W. To withdraw, roll it towards you, or hold S.</source>
        <translation>Γυρίστε τον τροχό προς τα εμπρός ή κρατήστε το W. Για απόσυρση γυρίστε τον προς τα πίσω ή κρατήστε το S.</translation>
    </message>
    <message>
        <source>Roll the wheel towards you, or hold Page Down. To raise, roll it away from you, or hold Page Up.</source>
        <translation>Γυρίστε τον τροχό προς τα πίσω ή κρατήστε το Page Down. Για ανέβασμα γυρίστε τον προς τα εμπρός ή κρατήστε το Page Up.</translation>
    </message>
    <message>
        <source>Take the handle and move it: the tool moves with it.</source>
        <translation>Πιάστε τη λαβή και μετακινήστε την: το εργαλείο κινείται μαζί της.</translation>
    </message>
    <message>
        <source>Push the handle in. To withdraw, pull it out.</source>
        <translation>Σπρώξτε τη λαβή προς τα μέσα. Για απόσυρση, τραβήξτε την προς τα έξω.</translation>
    </message>
    <message>
        <source>Turn and tilt the handle.</source>
        <translation>Στρέψτε και γείρετε τη λαβή.</translation>
    </message>
    <message>
        <source>Move the handle sideways.</source>
        <translation>Μετακινήστε τη λαβή στο πλάι.</translation>
    </message>
    <message>
        <source>Lower the handle. To raise the instrument, raise the handle.</source>
        <translation>Κατεβάστε τη λαβή. Για να σηκώσετε το εργαλείο, σηκώστε τη λαβή.</translation>
    </message>
    <message>
        <source>Close the grip of the handle. To open the jaw, open the grip.</source>
        <translation>Κλείστε τη λαβή. Για να ανοίξουν οι σιαγόνες, ανοίξτε τη λαβή.</translation>
    </message>
    <message>
        <source>Lower the handle until the tip makes contact. To raise the tip, raise the handle.</source>
        <translation>Κατεβάστε τη λαβή μέχρι να ακουμπήσει η άκρη. Για να σηκώσετε την άκρη, σηκώστε τη λαβή.</translation>
    </message>
    <message>
        <source>Press the button of the handle, or Enter, while you touch the place.</source>
        <translation>Πατήστε το κουμπί της λαβής ή το Enter ενώ ακουμπάτε το σημείο.</translation>
    </message>
    <message>
        <source>Change the instrument</source>
        <translation>Αλλαγή εργαλείου</translation>
    </message>
    <message>
        <source>You move one instrument at a time. Press 1 for the right one, 2 for the left one.</source>
        <translation>Κινείτε ένα εργαλείο τη φορά. Πατήστε 1 για το δεξί, 2 για το αριστερό.</translation>
    </message>
    <message>
        <source>You move one instrument at a time. Press its number, 1 to %1.</source>
        <translation>Κινείτε ένα εργαλείο τη φορά. Πατήστε τον αριθμό του, 1 έως %1.</translation>
    </message>
    <message>
        <source>Take the handle and move it: the finger moves with it.</source>
        <translation>Πιάστε τη λαβή και μετακινήστε την: το δάχτυλο κινείται μαζί της.</translation>
    </message>
    <message>
        <source>Push the handle down. To raise the finger, raise the handle.</source>
        <translation>Σπρώξτε τη λαβή προς τα κάτω. Για να σηκώσετε το δάχτυλο, σηκώστε τη λαβή.</translation>
    </message>
    <message>
        <source>Press the button of the handle, or Enter. When nothing is left to report, press D.</source>
        <translation>Πατήστε το κουμπί της λαβής ή το Enter. Όταν δεν υπάρχει τίποτα άλλο να αναφέρετε, πατήστε D.</translation>
    </message>
    <message>
        <source>Change hands</source>
        <translation>Αλλαγή χεριού</translation>
    </message>
    <message>
        <source>You move one hand at a time. Press H for the other one.</source>
        <translation>Κινείτε ένα χέρι τη φορά. Πατήστε H για το άλλο.</translation>
    </message>
    <message>
        <source>Hold the left button, or G. When you let go, the jaw stays as it is. To open it, hold Shift and the left button, or H.</source>
        <translation>Κρατήστε το αριστερό κουμπί ή το G. Όταν το αφήσετε, οι σιαγόνες μένουν όπως είναι. Για άνοιγμα κρατήστε το Shift και το αριστερό κουμπί, ή το H.</translation>
    </message>
</context>
<context>
    <name>DesignFaults</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 έως %2</translation>
    </message>
    <message>
        <source>%1 cannot be rendered. Choose a reference of %2.</source>
        <translation>Η τιμή %1 δεν μπορεί να αποδοθεί. Επιλέξτε αναφορά από %2.</translation>
    </message>
    <message>
        <source>An object would have %1, but only %2 can be rendered. Choose smaller differences or another reference.</source>
        <translation>Ένα αντικείμενο θα είχε %1, αλλά αποδίδονται μόνο τιμές %2. Επιλέξτε μικρότερες διαφορές ή άλλη αναφορά.</translation>
    </message>
    <message>
        <source>This task compares with objects above the reference only: every difference must be above 0 %.</source>
        <translation>Αυτό το έργο συγκρίνει μόνο με αντικείμενα πάνω από την αναφορά: κάθε διαφορά πρέπει να είναι πάνω από 0 %.</translation>
    </message>
    <message>
        <source>This is empty. Write something.</source>
        <translation>Το πεδίο είναι κενό. Συμπληρώστε το.</translation>
    </message>
    <message>
        <source>Use only lower-case letters, digits and _, and begin with a letter.</source>
        <translation>Χρησιμοποιήστε μόνο πεζά λατινικά γράμματα, ψηφία και _, με γράμμα στην αρχή.</translation>
    </message>
    <message>
        <source>A level lies outside the table of differences. Choose one within it, or change the table.</source>
        <translation>Ένα επίπεδο βρίσκεται εκτός του πίνακα διαφορών. Επιλέξτε ένα εντός του ή αλλάξτε τον πίνακα.</translation>
    </message>
    <message>
        <source>Choose a value from %1 to %2.</source>
        <translation>Επιλέξτε τιμή από %1 έως %2.</translation>
    </message>
    <message>
        <source>Found: %1. Expected: %2.</source>
        <translation>Βρέθηκε: %1. Αναμενόταν: %2.</translation>
    </message>
    <message>
        <source>At least one participant is needed.</source>
        <translation>Χρειάζεται τουλάχιστον ένα άτομο.</translation>
    </message>
    <message>
        <source>Another condition has the same name. Tables and figures could not tell them apart.</source>
        <translation>Μια άλλη συνθήκη έχει το ίδιο όνομα. Σε πίνακες και γραφήματα δεν θα ξεχώριζαν.</translation>
    </message>
    <message>
        <source>The lightest object weighs only %1 N, so lifting it would not count as touching. Choose a smaller force.</source>
        <translation>Το ελαφρύτερο αντικείμενο ζυγίζει μόνο %1 N, οπότε το σήκωμά του δεν θα μετρούσε ως άγγιγμα. Επιλέξτε μικρότερη δύναμη.</translation>
    </message>
    <message>
        <source>A trial with more than %1 N does not count, so this force has to be smaller.</source>
        <translation>Μια δοκιμή με περισσότερα από %1 N δεν μετρά, οπότε αυτή η δύναμη πρέπει να είναι μικρότερη.</translation>
    </message>
    <message>
        <source>The maximum has to be above the minimum.</source>
        <translation>Το μέγιστο πρέπει να είναι πάνω από το ελάχιστο.</translation>
    </message>
    <message>
        <source>Choose a value of at most %1.</source>
        <translation>Επιλέξτε τιμή έως %1.</translation>
    </message>
    <message>
        <source>A difference is listed twice. Remove one of them.</source>
        <translation>Μία διαφορά υπάρχει δύο φορές. Αφαιρέστε τη μία.</translation>
    </message>
    <message>
        <source>This is already used. Choose something else.</source>
        <translation>Υπάρχει ήδη. Επιλέξτε άλλο.</translation>
    </message>
    <message>
        <source>Enter %1 to %2 choices, one per line.</source>
        <translation>Εισαγάγετε %1 έως %2 επιλογές, μία ανά γραμμή.</translation>
    </message>
</context>
<context>
    <name>Drivers</name>
    <message>
        <source>Mouse and keyboard</source>
        <translation>Ποντίκι και πληκτρολόγιο</translation>
    </message>
    <message>
        <source>Ready. Moves the tool with a pointer or with keys.</source>
        <translation>Έτοιμα. Κινούν το εργαλείο με δείκτη ή με πλήκτρα.</translation>
    </message>
    <message>
        <source>Recorded trace</source>
        <translation>Καταγεγραμμένη κίνηση</translation>
    </message>
    <message>
        <source>Ready. Plays a trace file as if a hand moved the device.</source>
        <translation>Έτοιμη. Αναπαράγει ένα αρχείο κίνησης σαν να κινούσε ένα χέρι τη συσκευή.</translation>
    </message>
    <message>
        <source>Simulated gimbal</source>
        <translation>Προσομοιωμένη καρδανική συσκευή</translation>
    </message>
    <message>
        <source>Simulated five-bar mechanism</source>
        <translation>Προσομοιωμένος μηχανισμός πέντε ράβδων</translation>
    </message>
    <message>
        <source>Simulated arm with fingertip platform</source>
        <translation>Προσομοιωμένος βραχίονας με πλατφόρμα δακτύλου</translation>
    </message>
    <message>
        <source>Simulated mechanism with a scripted hand</source>
        <translation>Προσομοιωμένος μηχανισμός με προγραμματισμένο χέρι</translation>
    </message>
    <message>
        <source>Ready. Nothing needs to be connected.</source>
        <translation>Έτοιμη. Δεν χρειάζεται σύνδεση.</translation>
    </message>
    <message>
        <source>Exactly</source>
        <translation>Ακριβώς</translation>
    </message>
    <message>
        <source>By the published formulas (error up to 27 %)</source>
        <translation>Με τους δημοσιευμένους τύπους (σφάλμα έως 27 %)</translation>
    </message>
    <message>
        <source>How the gimbal renders force</source>
        <translation>Πώς η καρδανική συσκευή αποδίδει δύναμη</translation>
    </message>
    <message>
        <source>Haptic device (USB, network or serial line)</source>
        <translation>Απτική συσκευή (USB, δίκτυο ή σειριακή γραμμή)</translation>
    </message>
    <message>
        <source>Its forces are felt. Plug it in by USB, or give its address on the command line (see chiron-cli train --help). Tested against an emulation; it never met hardware.</source>
        <translation>Οι δυνάμεις της γίνονται αισθητές. Συνδέστε την μέσω USB ή δώστε τη διεύθυνσή της στη γραμμή εντολών (βλ. chiron-cli train --help). Δοκιμάστηκε με εξομοίωση· δεν έχει δοκιμαστεί ποτέ με πραγματικό υλικό.</translation>
    </message>
</context>
<context>
    <name>ErrorWords</name>
    <message>
        <source>%1
Details: %2</source>
        <translation>%1
Λεπτομέρειες: %2</translation>
    </message>
    <message>
        <source>Your account does not permit this. If you need it, ask an administrator.</source>
        <translation>Ο λογαριασμός σας δεν το επιτρέπει. Αν το χρειάζεστε, απευθυνθείτε σε διαχειριστή.</translation>
    </message>
    <message>
        <source>It no longer exists or was never created. Nothing was changed.</source>
        <translation>Δεν υπάρχει πλέον ή δεν δημιουργήθηκε ποτέ. Τίποτα δεν άλλαξε.</translation>
    </message>
    <message>
        <source>It could not be saved. What was recorded before is kept; check the free space and try again.</source>
        <translation>Η αποθήκευση απέτυχε. Όσα καταγράφηκαν πριν διατηρούνται· ελέγξτε τον ελεύθερο χώρο και δοκιμάστε ξανά.</translation>
    </message>
    <message>
        <source>Another program is writing to this database. Close the database there, then try again.</source>
        <translation>Ένα άλλο πρόγραμμα γράφει σε αυτή τη βάση δεδομένων. Κλείστε την εκεί και δοκιμάστε ξανά.</translation>
    </message>
    <message>
        <source>The device did not respond correctly. Check its cable and power, then try again.</source>
        <translation>Η συσκευή δεν ανταποκρίθηκε σωστά. Ελέγξτε το καλώδιο και την τροφοδοσία και δοκιμάστε ξανά.</translation>
    </message>
    <message>
        <source>The operation was stopped before it finished. Nothing was changed.</source>
        <translation>Η ενέργεια διακόπηκε πριν ολοκληρωθεί. Τίποτα δεν άλλαξε.</translation>
    </message>
    <message>
        <source>The check found errors.</source>
        <translation>Ο έλεγχος βρήκε σφάλματα.</translation>
    </message>
    <message>
        <source>The input is not valid. Nothing was changed.</source>
        <translation>Τα στοιχεία που δόθηκαν δεν είναι έγκυρα. Τίποτα δεν άλλαξε.</translation>
    </message>
    <message>
        <source>A file that the site needs is missing. Put it back, then try again. Nothing was changed.</source>
        <translation>Λείπει ένα αρχείο που χρειάζεται το κέντρο. Επαναφέρετέ το και δοκιμάστε ξανά. Τίποτα δεν άλλαξε.</translation>
    </message>
    <message>
        <source>It could not be read. Check that the drive is connected and that you may read the file, then try again. Nothing was changed.</source>
        <translation>Η ανάγνωση απέτυχε. Ελέγξτε ότι ο δίσκος είναι συνδεδεμένος και ότι έχετε δικαίωμα ανάγνωσης του αρχείου και δοκιμάστε ξανά. Τίποτα δεν άλλαξε.</translation>
    </message>
    <message>
        <source>The stored data are not valid. Nothing was changed.</source>
        <translation>Τα αποθηκευμένα δεδομένα δεν είναι έγκυρα. Τίποτα δεν άλλαξε.</translation>
    </message>
</context>
<context>
    <name>ExercisePart</name>
    <message>
        <source>The answers, seen from above</source>
        <translation>Οι απαντήσεις, από πάνω</translation>
    </message>
    <message>
        <source>How the endoscope followed the urethra</source>
        <translation>Πώς ακολούθησε το ενδοσκόπιο την ουρήθρα</translation>
    </message>
    <message>
        <source>How the tube was held and stretched</source>
        <translation>Πώς κρατήθηκε και τεντώθηκε ο σωλήνας</translation>
    </message>
    <message>
        <source>How each object was held and set down</source>
        <translation>Πώς κρατήθηκε και αποτέθηκε κάθε αντικείμενο</translation>
    </message>
    <message>
        <source>What was searched and what was found</source>
        <translation>Τι ερευνήθηκε και τι βρέθηκε</translation>
    </message>
    <message>
        <source>What was compared</source>
        <translation>Τι συγκρίθηκε</translation>
    </message>
    <message>
        <source>There is no answer to show. The session is kept and listed.</source>
        <translation>Δεν υπάρχει απάντηση για προβολή. Η συνεδρία διατηρείται και βρίσκεται στη λίστα.</translation>
    </message>
    <message>
        <source>There is nothing of the procedure to show. The session is kept and listed.</source>
        <translation>Δεν υπάρχει τίποτα για προβολή από τη διαδικασία. Η συνεδρία διατηρείται και βρίσκεται στη λίστα.</translation>
    </message>
    <message>
        <source>There is no tension to show. The session is kept and listed.</source>
        <translation>Δεν υπάρχει τάση για προβολή. Η συνεδρία διατηρείται και βρίσκεται στη λίστα.</translation>
    </message>
    <message>
        <source>There is no object to show. The session is kept and listed.</source>
        <translation>Δεν υπάρχει αντικείμενο για προβολή. Η συνεδρία διατηρείται και βρίσκεται στη λίστα.</translation>
    </message>
    <message>
        <source>There is no search to show. The session is kept and listed.</source>
        <translation>Δεν υπάρχει αναζήτηση για προβολή. Η συνεδρία διατηρείται και βρίσκεται στη λίστα.</translation>
    </message>
    <message>
        <source>What was compared and answered is shown with its study.</source>
        <translation>Τι συγκρίθηκε και τι απαντήθηκε φαίνεται στη μελέτη.</translation>
    </message>
    <message>
        <source>Result of each trial</source>
        <translation>Το αποτέλεσμα κάθε δοκιμής</translation>
    </message>
    <message>
        <source>%1 of %2 landmarks of the bladder were seen.</source>
        <translation>Φάνηκαν %1 από τα %2 οδηγά σημεία της κύστης.</translation>
    </message>
</context>
<context>
    <name>ExitBackup</name>
    <message>
        <source>Making today&apos;s backup</source>
        <translation>Δημιουργείται το σημερινό αντίγραφο ασφαλείας</translation>
    </message>
    <message>
        <source>Chiron closes by itself when the backup is made and checked.</source>
        <translation>Το Chiron κλείνει μόνο του μόλις το αντίγραφο ασφαλείας δημιουργηθεί και ελεγχθεί.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Πρόοδος</translation>
    </message>
    <message>
        <source>Close without a backup</source>
        <translation>Κλείσιμο χωρίς αντίγραφο ασφαλείας</translation>
    </message>
</context>
<context>
    <name>FeltWords</name>
    <message>
        <source>%1: force felt</source>
        <translation>%1: αισθητή δύναμη</translation>
    </message>
    <message>
        <source>%1: force shown, not felt</source>
        <translation>%1: μόνο προβολή δύναμης</translation>
    </message>
    <message>
        <source>This level shows no measurements: rely on what you feel. Everything is recorded and appears in the results.</source>
        <translation>Αυτό το επίπεδο δεν δείχνει μετρήσεις: εργαστείτε με την αφή. Όλα καταγράφονται και εμφανίζονται στα αποτελέσματα.</translation>
    </message>
    <message>
        <source>This level shows no measurements: rely on the scene. Everything is recorded and appears in the results.</source>
        <translation>Αυτό το επίπεδο δεν δείχνει μετρήσεις: καθοδηγηθείτε από τη σκηνή. Όλα καταγράφονται και εμφανίζονται στα αποτελέσματα.</translation>
    </message>
    <message>
        <source>You feel the objects through the device.</source>
        <translation>Νιώθετε τα αντικείμενα μέσω της συσκευής.</translation>
    </message>
    <message>
        <source>This device renders no force: the force is shown beside the scene.</source>
        <translation>Αυτή η συσκευή δεν αποδίδει δύναμη: η δύναμη εμφανίζεται δίπλα στη σκηνή.</translation>
    </message>
    <message>
        <source>Space pauses. Esc stops force at once, and R brings it back slowly; Esc again asks whether to stop.</source>
        <translation>Το Διάστημα κάνει παύση. Το Esc σταματά αμέσως τη δύναμη και το R την επαναφέρει αργά· με δεύτερο Esc το πρόγραμμα ρωτά αν θέλετε διακοπή.</translation>
    </message>
    <message>
        <source>Space pauses. Esc stops the trial at once, and R goes on; Esc again asks whether to stop the session.</source>
        <translation>Το Διάστημα κάνει παύση. Το Esc σταματά αμέσως τη δοκιμή και το R τη συνεχίζει· με δεύτερο Esc το πρόγραμμα ρωτά αν θα διακοπεί η συνεδρία.</translation>
    </message>
    <message>
        <source>Esc stops force at once; pressed again, it asks whether to stop the session. T frees the pointer.</source>
        <translation>Το Esc σταματά αμέσως τη δύναμη· αν το πατήσετε ξανά, το πρόγραμμα ρωτά αν θα διακοπεί η συνεδρία. Το T απελευθερώνει τον δείκτη.</translation>
    </message>
    <message>
        <source>Esc stops the trial at once; pressed again, it asks whether to stop the session. T frees the pointer.</source>
        <translation>Το Esc σταματά αμέσως τη δοκιμή· αν το πατήσετε ξανά, το πρόγραμμα ρωτά αν θα διακοπεί η συνεδρία. Το T απελευθερώνει τον δείκτη.</translation>
    </message>
    <message>
        <source>Force is stopped</source>
        <translation>Η δύναμη σταμάτησε</translation>
    </message>
    <message>
        <source>The trial is stopped</source>
        <translation>Η δοκιμή σταμάτησε</translation>
    </message>
    <message>
        <source>Stop force</source>
        <translation>Διακοπή δύναμης</translation>
    </message>
    <message>
        <source>Stop the trial</source>
        <translation>Διακοπή της δοκιμής</translation>
    </message>
    <message>
        <source>Re-arm force</source>
        <translation>Ενεργοποίηση δύναμης</translation>
    </message>
    <message>
        <source>Go on after a stop</source>
        <translation>Συνέχεια μετά τη διακοπή</translation>
    </message>
</context>
<context>
    <name>ForceWords</name>
    <message>
        <source>Force is stopped</source>
        <translation>Η δύναμη σταμάτησε</translation>
    </message>
    <message>
        <source>The clock is stopped and everything so far is kept. Press Re-arm (or R) to go on, or End session.</source>
        <translation>Ο χρόνος έχει σταματήσει και όλα ως τώρα διατηρούνται. Πατήστε «Ενεργοποίηση» (ή R) για να συνεχίσετε, ή «Τέλος συνεδρίας».</translation>
    </message>
    <message>
        <source>The safety supervisor switched the force off.</source>
        <translation>Ο επόπτης δύναμης διέκοψε τη δύναμη.</translation>
    </message>
    <message>
        <source>The tool moved faster than is safe, so force was switched off.</source>
        <translation>Το εργαλείο κινήθηκε ταχύτερα από όσο είναι ασφαλές και η δύναμη διακόπηκε.</translation>
    </message>
    <message>
        <source>The device&apos;s data came too late, so force was switched off.</source>
        <translation>Τα δεδομένα της συσκευής καθυστέρησαν πολύ και η δύναμη διακόπηκε.</translation>
    </message>
    <message>
        <source>The device sent impossible positions, so force was switched off.</source>
        <translation>Η συσκευή έστειλε θέσεις που δεν είναι δυνατές και η δύναμη διακόπηκε.</translation>
    </message>
    <message>
        <source>The device reports a fault, so force was switched off.</source>
        <translation>Η συσκευή αναφέρει βλάβη και η δύναμη διακόπηκε.</translation>
    </message>
    <message>
        <source>The calculated force was invalid (not a number), so force was switched off. Please report this.</source>
        <translation>Η υπολογισμένη δύναμη δεν ήταν έγκυρη (δεν ήταν αριθμός) και η δύναμη διακόπηκε. Παρακαλούμε αναφέρετέ το.</translation>
    </message>
    <message>
        <source>The clock is stopped and everything so far is kept. Hold the tool safely, then press Re-arm (or R).</source>
        <translation>Ο χρόνος έχει σταματήσει και όλα ως τώρα διατηρούνται. Κρατήστε το εργαλείο με ασφάλεια και πατήστε «Ενεργοποίηση» (ή R).</translation>
    </message>
    <message>
        <source>Waiting for the device</source>
        <translation>Αναμονή για τη συσκευή</translation>
    </message>
    <message>
        <source>The device has not sent a valid position yet. Check that it is switched on.</source>
        <translation>Η συσκευή δεν έχει στείλει ακόμη έγκυρη θέση. Ελέγξτε αν είναι ανοιχτή.</translation>
    </message>
    <message>
        <source>Hold still</source>
        <translation>Μείνετε ακίνητοι</translation>
    </message>
    <message>
        <source>Hold the tool still for half a second; force then rises slowly.</source>
        <translation>Κρατήστε το εργαλείο ακίνητο για μισό δευτερόλεπτο· η δύναμη αυξάνεται μετά αργά.</translation>
    </message>
    <message>
        <source>Force is on hold</source>
        <translation>Η δύναμη έχει ανασταλεί</translation>
    </message>
    <message>
        <source>The window did not respond for a moment. Force comes back by itself.</source>
        <translation>Το παράθυρο δεν ανταποκρίθηκε για λίγο. Η δύναμη επανέρχεται μόνη της.</translation>
    </message>
    <message>
        <source>Force is not on yet</source>
        <translation>Η δύναμη δεν είναι ακόμη ενεργή</translation>
    </message>
    <message>
        <source>Move the tool until it touches nothing, or hold it still and press Resume here.</source>
        <translation>Μετακινήστε το εργαλείο ώστε να μην αγγίζει τίποτα, ή κρατήστε το ακίνητο και πατήστε «Συνέχεια εδώ».</translation>
    </message>
    <message>
        <source>You are watching</source>
        <translation>Παρακολουθείτε</translation>
    </message>
    <message>
        <source>Force is shown, not felt.</source>
        <translation>Η δύναμη προβάλλεται, δεν γίνεται αισθητή.</translation>
    </message>
    <message>
        <source>No movement</source>
        <translation>Καμία κίνηση</translation>
    </message>
    <message>
        <source>Nothing has moved for two seconds. Move the mouse over the scene or press an arrow key.</source>
        <translation>Τίποτα δεν κινήθηκε για δύο δευτερόλεπτα. Μετακινήστε το ποντίκι πάνω στη σκηνή ή πατήστε ένα βέλος.</translation>
    </message>
    <message>
        <source>Shown, not felt</source>
        <translation>Μόνο προβολή δύναμης</translation>
    </message>
    <message>
        <source>This device renders no force. The tool stays at the surface and moves more slowly the harder you press.</source>
        <translation>Αυτή η συσκευή δεν αποδίδει δύναμη. Το εργαλείο μένει στην επιφάνεια· όσο πιο δυνατά πιέζετε, τόσο πιο αργά κινείται.</translation>
    </message>
    <message>
        <source>Getting ready</source>
        <translation>Προετοιμασία</translation>
    </message>
    <message>
        <source>The first trial begins as soon as the scene is drawn.</source>
        <translation>Η πρώτη δοκιμή αρχίζει μόλις σχεδιαστεί η σκηνή.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Σε παύση</translation>
    </message>
    <message>
        <source>The clock is stopped. Press Resume or Space to go on.</source>
        <translation>Ο χρόνος έχει σταματήσει. Πατήστε «Συνέχεια» ή Διάστημα για να συνεχίσετε.</translation>
    </message>
    <message>
        <source>Force is rising</source>
        <translation>Η δύναμη αυξάνεται</translation>
    </message>
    <message>
        <source>It rises slowly (now %1 %). The clock starts once it has reached full strength.</source>
        <translation>Αυξάνεται αργά (τώρα %1 %). Ο χρόνος ξεκινά μόλις φτάσει στην πλήρη ένταση.</translation>
    </message>
    <message>
        <source>Force is on</source>
        <translation>Η δύναμη είναι ενεργή</translation>
    </message>
    <message>
        <source>Esc stops it at once.</source>
        <translation>Το Esc τη σταματά αμέσως.</translation>
    </message>
    <message>
        <source>The device&apos;s data arrive late. Force comes back when they arrive on time again.</source>
        <translation>Τα δεδομένα της συσκευής καθυστερούν. Η δύναμη επανέρχεται όταν φτάνουν πάλι εγκαίρως.</translation>
    </message>
    <message>
        <source>The operator&apos;s force waits until the tool is free.</source>
        <translation>Η δύναμη του χειριστή περιμένει ώσπου να ελευθερωθεί το εργαλείο.</translation>
    </message>
    <message>
        <source>The operator&apos;s force rises slowly (%1 %).</source>
        <translation>Η δύναμη του χειριστή αυξάνεται αργά (%1 %).</translation>
    </message>
    <message>
        <source>The operator&apos;s force is on hold for a moment and comes back by itself.</source>
        <translation>Η δύναμη του χειριστή αναστέλλεται για λίγο και επανέρχεται μόνη της.</translation>
    </message>
    <message>
        <source>This device renders no force. The endoscope moves more slowly the harder you press.</source>
        <translation>Αυτή η συσκευή δεν αποδίδει δύναμη. Όσο πιο δυνατά πιέζετε, τόσο πιο αργά κινείται το ενδοσκόπιο.</translation>
    </message>
    <message>
        <source>The procedure begins as soon as the scene is drawn.</source>
        <translation>Η διαδικασία αρχίζει μόλις σχεδιαστεί η σκηνή.</translation>
    </message>
    <message>
        <source>This device renders no force. An instrument moves more slowly the harder something pulls or presses.</source>
        <translation>Αυτή η συσκευή δεν αποδίδει δύναμη. Όσο πιο δυνατά τραβιέται ή πιέζεται ένα εργαλείο, τόσο πιο αργά κινείται.</translation>
    </message>
</context>
<context>
    <name>FreezeChecks</name>
    <message>
        <source>Entries</source>
        <translation>Καταχωρίσεις</translation>
    </message>
    <message>
        <source>All entries are complete and fit together.</source>
        <translation>Όλες οι καταχωρίσεις είναι πλήρεις και συμβατές μεταξύ τους.</translation>
    </message>
    <message numerus="yes">
        <source>%n entr(y/ies) must be corrected. The first: %1</source>
        <translation>
            <numerusform>%n καταχώριση πρέπει να διορθωθεί: %1</numerusform>
            <numerusform>%n καταχωρίσεις πρέπει να διορθωθούν. Η πρώτη: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Σκοπός</translation>
    </message>
    <message>
        <source>Write what is to be found out and what you expect. It cannot be added later.</source>
        <translation>Γράψτε τι θέλετε να διαπιστώσετε και τι αναμένετε. Αργότερα δεν μπορεί να προστεθεί.</translation>
    </message>
    <message>
        <source>Ethics</source>
        <translation>Δεοντολογία</translation>
    </message>
    <message>
        <source>Name the approval, or say why none is needed.</source>
        <translation>Αναφέρετε την έγκριση ή εξηγήστε γιατί δεν χρειάζεται.</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Συγκατάθεση</translation>
    </message>
    <message>
        <source>Write what participants agree to.</source>
        <translation>Γράψτε σε τι συγκατατίθενται οι συμμετέχοντες.</translation>
    </message>
    <message>
        <source>The text is very short. Check that it says what is recorded, for how long, and that stopping has no disadvantage.</source>
        <translation>Το κείμενο είναι πολύ σύντομο. Ελέγξτε ότι αναφέρει τι καταγράφεται, για πόσο διάστημα, και ότι η διακοπή δεν έχει δυσμενείς συνέπειες.</translation>
    </message>
    <message>
        <source>There is a text; participants read it before their first trial.</source>
        <translation>Υπάρχει κείμενο· οι συμμετέχοντες το διαβάζουν πριν από την πρώτη δοκιμή.</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Συμμετέχοντες</translation>
    </message>
    <message>
        <source>Plan at least one participant.</source>
        <translation>Προγραμματίστε τουλάχιστον ένα άτομο.</translation>
    </message>
    <message>
        <source>%1 are planned. With a multiple of %2 every order of conditions comes equally often.</source>
        <translation>Προβλέπονται %1. Με πολλαπλάσιο του %2 κάθε σειρά των συνθηκών εμφανίζεται εξίσου συχνά.</translation>
    </message>
    <message>
        <source>%1 are planned.</source>
        <translation>Προβλέπονται %1.</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Εξάσκηση</translation>
    </message>
    <message>
        <source>There are no practice trials. The first trials that count are then the participant&apos;s first ever.</source>
        <translation>Δεν υπάρχουν δοκιμές εξάσκησης. Οι πρώτες δοκιμές που μετρούν είναι τότε και οι πρώτες του ατόμου.</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Διάρκεια</translation>
    </message>
    <message>
        <source>About %1 minutes for each participant, as simulated.</source>
        <translation>Περίπου %1 λεπτά ανά άτομο, κατά την προσομοίωση.</translation>
    </message>
    <message>
        <source>Attention wanes after an hour: plan fewer trials or several sessions.</source>
        <translation>Μετά από μία ώρα η προσοχή μειώνεται: προγραμματίστε λιγότερες δοκιμές ή περισσότερες συνεδρίες.</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Ακρίβεια</translation>
    </message>
    <message>
        <source>This kind of study estimates no threshold, so there is none to simulate. A pilot shows how much answers vary.</source>
        <translation>Αυτό το είδος μελέτης δεν εκτιμά κατώφλι, άρα δεν υπάρχει τι να προσομοιωθεί. Μια πιλοτική δοκιμή δείχνει πόσο διαφέρουν οι απαντήσεις.</translation>
    </message>
    <message>
        <source>The threshold of one run varies by a factor of %1.</source>
        <translation>Το κατώφλι μιας εκτέλεσης μεταβάλλεται κατά συντελεστή %1.</translation>
    </message>
    <message>
        <source>Pilot</source>
        <translation>Πιλοτική δοκιμή</translation>
    </message>
    <message numerus="yes">
        <source>Tried %n time(s).</source>
        <translation>
            <numerusform>Δοκιμάστηκε %n φορά.</numerusform>
            <numerusform>Δοκιμάστηκε %n φορές.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody has tried this design yet. Try it yourself first: a few minutes show what is unclear.</source>
        <translation>Κανείς δεν έχει δοκιμάσει ακόμη αυτό το σχέδιο. Δοκιμάστε το πρώτα εσείς: λίγα λεπτά δείχνουν τι είναι ασαφές.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) before each condition.</source>
        <translation>
            <numerusform>%n δοκιμή πριν από κάθε συνθήκη.</numerusform>
            <numerusform>%n δοκιμές πριν από κάθε συνθήκη.</numerusform>
        </translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Κείμενα</translation>
    </message>
    <message>
        <source>Nothing in the aim, the instructions or the titles contradicts the settings.</source>
        <translation>Τίποτα στον σκοπό, στις οδηγίες και στους τίτλους δεν αντιφάσκει με τις ρυθμίσεις.</translation>
    </message>
    <message>
        <source>Smallest force</source>
        <translation>Μικρότερη δύναμη</translation>
    </message>
    <message>
        <source>An object counts as touched from %1 N on.</source>
        <translation>Το άγγιγμα ενός αντικειμένου μετράει από %1 N και πάνω.</translation>
    </message>
    <message>
        <source>Any graze counts as touching, so participants can answer without having felt anything. %1 N is usual.</source>
        <translation>Και το πιο ελαφρύ άγγιγμα μετρά, οπότε οι συμμετέχοντες μπορούν να απαντήσουν χωρίς να έχουν νιώσει τίποτα. Συνήθως ορίζονται %1 N.</translation>
    </message>
    <message>
        <source>Masking sound</source>
        <translation>Ήχος κάλυψης</translation>
    </message>
    <message>
        <source>It is switched off. Participants may hear the device, and its sound may tell them which object is which.</source>
        <translation>Είναι απενεργοποιημένος. Οι συμμετέχοντες ίσως ακούν τη συσκευή, και ο ήχος της μπορεί να προδίδει ποιο αντικείμενο είναι ποιο.</translation>
    </message>
    <message>
        <source>It is played during the trials.</source>
        <translation>Ακούγεται κατά τις δοκιμές.</translation>
    </message>
    <message>
        <source>This machine has no sound output, so participants would hear the device. Connect headphones or loudspeakers, or run the study on another machine.</source>
        <translation>Αυτός ο υπολογιστής δεν έχει έξοδο ήχου, οπότε οι συμμετέχοντες θα άκουγαν τη συσκευή. Συνδέστε ακουστικά ή ηχεία ή διεξαγάγετε τη μελέτη σε άλλον υπολογιστή.</translation>
    </message>
    <message>
        <source>The aim is written down.</source>
        <translation>Ο σκοπός έχει διατυπωθεί.</translation>
    </message>
    <message>
        <source>One participant says nothing about others. Plan more, unless this is a case study.</source>
        <translation>Ένα μόνο άτομο δεν λέει τίποτα για τα υπόλοιπα. Προγραμματίστε περισσότερα, εκτός αν πρόκειται για μελέτη περίπτωσης.</translation>
    </message>
    <message>
        <source>Simulated observers are still running through the study …</source>
        <translation>Προσομοιωμένοι παρατηρητές εκτελούν ακόμη τη μελέτη …</translation>
    </message>
    <message>
        <source>Usable values</source>
        <translation>Αξιοποιήσιμες τιμές</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Δύναμη</translation>
    </message>
    <message>
        <source>The device of this station renders force.</source>
        <translation>Η συσκευή αυτού του σταθμού αποδίδει δύναμη.</translation>
    </message>
    <message>
        <source>More trials make it more precise; the page “Expected precision” shows how many.</source>
        <translation>Περισσότερες δοκιμές το κάνουν ακριβέστερο· η σελίδα «Αναμενόμενη ακρίβεια» δείχνει πόσες.</translation>
    </message>
    <message>
        <source>Not possible yet. Correct first: %1. “Show” beside the red line leads there.</source>
        <translation>Δεν είναι ακόμη δυνατό. Διορθώστε πρώτα: %1. Το «Εμφάνιση» δίπλα στην κόκκινη γραμμή σας οδηγεί εκεί.</translation>
    </message>
    <message>
        <source>Please wait a moment: simulated observers are still running through the study.</source>
        <translation>Περιμένετε λίγο: οι προσομοιωμένοι παρατηρητές διατρέχουν ακόμη τη μελέτη.</translation>
    </message>
    <message>
        <source>Tick the box above first: it confirms what is marked as worth a look.</source>
        <translation>Τσεκάρετε πρώτα το πλαίσιο επάνω: επιβεβαιώνει όσα σημειώνονται ως άξια προσοχής.</translation>
    </message>
    <message>
        <source>An object counts as explored once it is lifted off the table.</source>
        <translation>Ένα αντικείμενο θεωρείται ότι εξερευνήθηκε μόλις σηκωθεί από το τραπέζι.</translation>
    </message>
    <message>
        <source>For each participant: %1.</source>
        <translation>Ανά άτομο: %1.</translation>
    </message>
    <message>
        <source>With %1 participants, a comparison of two conditions finds a difference with 80 % power if the Weber fraction of one is at least %2 times that of the other.</source>
        <translation>Με %1 συμμετέχοντες, η σύγκριση δύο συνθηκών βρίσκει διαφορά με ισχύ 80 %, αν το κλάσμα Weber της μίας είναι τουλάχιστον %2 φορές εκείνο της άλλης.</translation>
    </message>
    <message>
        <source>With so few participants, a comparison of two conditions would often fail to show even a Weber fraction that is ten times the other.</source>
        <translation>Με τόσο λίγους συμμετέχοντες, η σύγκριση δύο συνθηκών θα παρέβλεπε συχνά ακόμη και κλάσμα Weber δεκαπλάσιο του άλλου.</translation>
    </message>
</context>
<context>
    <name>GateWords</name>
    <message>
        <source>%1 % of the radius</source>
        <translation>%1 % της ακτίνας</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1: από %2 έως %3</translation>
    </message>
    <message>
        <source>%1: at least %2</source>
        <translation>%1: τουλάχιστον %2</translation>
    </message>
    <message>
        <source>%1: at most %2</source>
        <translation>%1: το πολύ %2</translation>
    </message>
    <message>
        <source>%1: none</source>
        <translation>%1: κανένα</translation>
    </message>
    <message>
        <source>%1: at most %2 N, with %3 % more for the time it takes to react</source>
        <translation>%1: το πολύ %2 N, με περιθώριο %3 % για τον χρόνο αντίδρασης</translation>
    </message>
    <message>
        <source>Force limit: %1 N</source>
        <translation>Όριο δύναμης: %1 N</translation>
    </message>
    <message>
        <source>Squeeze: %1 N at most</source>
        <translation>Σύσφιξη: έως %1 N</translation>
    </message>
    <message>
        <source>Pull on the fold: %1 N at most</source>
        <translation>Έλξη της πτυχής: έως %1 N</translation>
    </message>
    <message>
        <source>At the end: %1 mm from the middle of the ring at most, on average</source>
        <translation>Στο τέλος: έως %1 mm από το κέντρο του δακτυλίου, κατά μέσο όρο</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, in every trial</source>
        <translation>%1, σε κάθε δοκιμή</translation>
    </message>
    <message>
        <source>Force across the canal: %1 N at most; pressing harder is a trauma event</source>
        <translation>Πλάγια δύναμη στον αυλό: έως %1 N· μεγαλύτερη πίεση είναι συμβάν τραυματισμού</translation>
    </message>
</context>
<context>
    <name>GraspNote</name>
    <message>
        <source>Nothing was grasped</source>
        <translation>Δεν πιάστηκε τίποτα</translation>
    </message>
    <message>
        <source>Nothing was grasped: the fold still lies over the tube. Retract it first.</source>
        <translation>Δεν πιάστηκε τίποτα: η πτυχή σκεπάζει ακόμη τον σωλήνα. Τραβήξτε την πρώτα πίσω.</translation>
    </message>
    <message>
        <source>Nothing was grasped. Open the jaws and try again.</source>
        <translation>Δεν πιάστηκε τίποτα. Ανοίξτε τις σιαγόνες και δοκιμάστε ξανά.</translation>
    </message>
    <message>
        <source>Nothing was grasped: the edge of the fold was %1 mm away. Open the jaws and move closer to it.</source>
        <translation>Δεν πιάστηκε τίποτα: η άκρη της πτυχής ήταν %1 mm μακριά. Ανοίξτε τις σιαγόνες και πλησιάστε την.</translation>
    </message>
    <message>
        <source>Nothing was grasped: the object was %1 mm away. Open the jaws and move closer to it.</source>
        <translation>Δεν πιάστηκε τίποτα: το αντικείμενο ήταν %1 mm μακριά. Ανοίξτε τις σιαγόνες και πλησιάστε το.</translation>
    </message>
    <message>
        <source>Nothing was grasped: the place to grip the tube was %1 mm away. Open the jaws and move closer to it.</source>
        <translation>Δεν πιάστηκε τίποτα: το σημείο όπου πιάνεται ο σωλήνας ήταν %1 mm μακριά. Ανοίξτε τις σιαγόνες και πλησιάστε το.</translation>
    </message>
    <message>
        <source>Nothing is grasped: the jaws are closed. Open them wide, then close them here.</source>
        <translation>Δεν πιάνεται τίποτα: οι σιαγόνες είναι κλειστές. Ανοίξτε τις καλά και μετά κλείστε τις εδώ.</translation>
    </message>
</context>
<context>
    <name>GraspWords</name>
    <message>
        <source>Take hold of both ends of the tube, one with each instrument</source>
        <translation>Πιάστε και τα δύο άκρα του σωλήνα, ένα με κάθε εργαλείο</translation>
    </message>
    <message>
        <source>Take hold of the end of the tube with the right instrument</source>
        <translation>Πιάστε το άκρο του σωλήνα με το δεξί εργαλείο</translation>
    </message>
    <message>
        <source>Take hold of the end of the tube</source>
        <translation>Πιάστε το άκρο του σωλήνα</translation>
    </message>
    <message>
        <source>At the mark: hold it there</source>
        <translation>Στο σημάδι: κρατήστε τον εκεί</translation>
    </message>
    <message>
        <source>At the target: hold it there</source>
        <translation>Στον στόχο: κρατήστε το εκεί</translation>
    </message>
    <message>
        <source>In the band: keep the tension there</source>
        <translation>Στη ζώνη: κρατήστε εκεί την τάση</translation>
    </message>
    <message>
        <source>The tube is torn: this trial is over</source>
        <translation>Ο σωλήνας σχίστηκε: αυτή η δοκιμή τελείωσε</translation>
    </message>
    <message>
        <source>Stretch the tube to the mark, and no farther</source>
        <translation>Τεντώστε τον σωλήνα ως το σημάδι και όχι πιο πέρα</translation>
    </message>
    <message>
        <source>Pull until the tension is in its band</source>
        <translation>Τραβήξτε ώσπου η τάση να μπει στη ζώνη της</translation>
    </message>
    <message>
        <source>Take the tube over with the left instrument, then let go with the right one</source>
        <translation>Πιάστε τον σωλήνα με το αριστερό εργαλείο, έπειτα αφήστε τον με το δεξί</translation>
    </message>
    <message>
        <source>Lift the end of the tube</source>
        <translation>Σηκώστε το άκρο του σωλήνα</translation>
    </message>
    <message>
        <source>Bring the end of the tube to the target</source>
        <translation>Φέρτε το άκρο του σωλήνα στον στόχο</translation>
    </message>
    <message>
        <source>Let go of the end of the tube</source>
        <translation>Αφήστε το άκρο του σωλήνα</translation>
    </message>
    <message>
        <source>Done: the next tube follows</source>
        <translation>Έτοιμο: ακολουθεί ο επόμενος σωλήνας</translation>
    </message>
    <message>
        <source>Wait for the tube</source>
        <translation>Περιμένετε τον σωλήνα</translation>
    </message>
    <message>
        <source>Lift one object after the other and find the heaviest</source>
        <translation>Σηκώστε το ένα αντικείμενο μετά το άλλο και βρείτε το βαρύτερο</translation>
    </message>
    <message>
        <source>Grasp the object gently</source>
        <translation>Πιάστε απαλά το αντικείμενο</translation>
    </message>
    <message>
        <source>Lift it up</source>
        <translation>Σηκώστε το</translation>
    </message>
    <message>
        <source>Done: the next one follows</source>
        <translation>Έτοιμο: ακολουθεί το επόμενο</translation>
    </message>
    <message>
        <source>Wait for the object</source>
        <translation>Περιμένετε το αντικείμενο</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Εργαλείο</translation>
    </message>
    <message>
        <source>Right instrument</source>
        <translation>Δεξί εργαλείο</translation>
    </message>
    <message>
        <source>Left instrument</source>
        <translation>Αριστερό εργαλείο</translation>
    </message>
    <message>
        <source>Instrument %1</source>
        <translation>Εργαλείο %1</translation>
    </message>
    <message>
        <source>Holding: object %1 of %2</source>
        <translation>Κρατάτε: αντικείμενο %1 από %2</translation>
    </message>
    <message>
        <source>Holding: the object</source>
        <translation>Κρατάτε: το αντικείμενο</translation>
    </message>
    <message>
        <source>Holding: the tube at two points</source>
        <translation>Κρατάτε: τον σωλήνα σε δύο σημεία</translation>
    </message>
    <message>
        <source>Holding: the tube</source>
        <translation>Κρατάτε: τον σωλήνα</translation>
    </message>
    <message>
        <source>Holding: nothing</source>
        <translation>Κρατάτε: τίποτα</translation>
    </message>
    <message>
        <source>Retract the fold of tissue with the third instrument until the pull is in the band</source>
        <translation>Τραβήξτε πίσω την πτυχή ιστού με το τρίτο εργαλείο μέχρι η έλξη της να βρεθεί μέσα στη ζώνη</translation>
    </message>
    <message>
        <source>Holding: the fold</source>
        <translation>Κρατάτε: την πτυχή</translation>
    </message>
    <message>
        <source>Is it the heaviest? Bring it over the ring; otherwise set it down</source>
        <translation>Είναι το βαρύτερο; Φέρτε το πάνω από τον δακτύλιο· αλλιώς αφήστε το κάτω</translation>
    </message>
    <message>
        <source>Bring it over the ring</source>
        <translation>Φέρτε το πάνω από τον δακτύλιο</translation>
    </message>
    <message>
        <source>Set it down inside the ring and let go</source>
        <translation>Ακουμπήστε το μέσα στον δακτύλιο και αφήστε το</translation>
    </message>
    <message>
        <source>In the ring: let it lie still</source>
        <translation>Στον δακτύλιο: αφήστε το ακίνητο</translation>
    </message>
    <message>
        <source>Set it down in the middle of the ring, at most %1 mm off, and let go</source>
        <translation>Ακουμπήστε το στο κέντρο του δακτυλίου, με απόκλιση έως %1 mm, και αφήστε το</translation>
    </message>
    <message>
        <source>Holding: the fold, and the tube at two points</source>
        <translation>Κρατάτε: την πτυχή, και τον σωλήνα σε δύο σημεία</translation>
    </message>
    <message>
        <source>Holding: the fold, and the tube at one point</source>
        <translation>Κρατάτε: την πτυχή, και τον σωλήνα σε ένα σημείο</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Close</source>
        <translation>Κλείσιμο</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Συντομεύσεις πληκτρολογίου</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <translation>Βοήθεια: %1</translation>
    </message>
    <message>
        <source>Keys on this screen</source>
        <translation>Πλήκτρα σε αυτή την οθόνη</translation>
    </message>
</context>
<context>
    <name>KeyNames</name>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Page Up</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Page Down</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Delete</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Backspace</translation>
    </message>
</context>
<context>
    <name>LearningCurve</name>
    <message>
        <source>%1 over the attempts</source>
        <translation>%1 ανά προσπάθεια</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>benchmark, felt (%1)</source>
        <translation>τιμή αναφοράς, αισθητή (%1)</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>αισθητή</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>μόνο προβολή</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>όριο επιτυχίας %1</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Προσπάθεια</translation>
    </message>
    <message>
        <source>No completed attempt yet</source>
        <translation>Δεν υπάρχει ακόμη ολοκληρωμένη προσπάθεια</translation>
    </message>
</context>
<context>
    <name>LevelFacts</name>
    <message>
        <source>Tissue: normal</source>
        <translation>Ιστός: φυσιολογικός</translation>
    </message>
    <message>
        <source>Tissue: tight urethra</source>
        <translation>Ιστός: στενή ουρήθρα</translation>
    </message>
    <message>
        <source>Tissue: with a stricture, a narrow and stiff ring</source>
        <translation>Ιστός: με στένωμα, έναν στενό και δύσκαμπτο δακτύλιο</translation>
    </message>
    <message>
        <source>Tissue: %1</source>
        <translation>Ιστός: %1</translation>
    </message>
    <message>
        <source>Depth of field: on, fixed</source>
        <translation>Βάθος πεδίου: ενεργό, δεν απενεργοποιείται</translation>
    </message>
    <message>
        <source>Depth of field: off, fixed</source>
        <translation>Βάθος πεδίου: ανενεργό, δεν ενεργοποιείται</translation>
    </message>
    <message>
        <source>Depth of field: on, can be switched off</source>
        <translation>Βάθος πεδίου: ενεργό, μπορεί να απενεργοποιηθεί</translation>
    </message>
    <message>
        <source>Depth of field: off, can be switched on</source>
        <translation>Βάθος πεδίου: ανενεργό, μπορεί να ενεργοποιηθεί</translation>
    </message>
    <message>
        <source>Distance: %1 mm in, then back out</source>
        <translation>Διαδρομή: %1 mm προς τα μέσα και πάλι έξω</translation>
    </message>
    <message>
        <source>Distance: %1 mm in</source>
        <translation>Διαδρομή: %1 mm προς τα μέσα</translation>
    </message>
    <message>
        <source>Help: the path is marked in the picture, and a second picture shows it from outside</source>
        <translation>Βοήθεια: η πορεία σημειώνεται στην εικόνα και μια δεύτερη εικόνα τη δείχνει εξωτερικά</translation>
    </message>
    <message>
        <source>Help: the path is marked in the picture</source>
        <translation>Βοήθεια: η πορεία σημειώνεται στην εικόνα</translation>
    </message>
    <message>
        <source>Help: a second picture shows the endoscope from outside</source>
        <translation>Βοήθεια: μια δεύτερη εικόνα δείχνει το ενδοσκόπιο εξωτερικά</translation>
    </message>
    <message>
        <source>Help: none, only the endoscope&apos;s picture</source>
        <translation>Βοήθεια: καμία, μόνο η εικόνα του ενδοσκοπίου</translation>
    </message>
    <message>
        <source>Landmarks of the bladder to inspect: %1</source>
        <translation>Οδηγά σημεία της κύστης προς επισκόπηση: %1</translation>
    </message>
    <message>
        <source>Goal: a tension between %1 and %2 N, held within ±%3 N for %4 s</source>
        <translation>Στόχος: τάση μεταξύ %1 και %2 N, σταθερή εντός ±%3 N για %4 s</translation>
    </message>
    <message>
        <source>Goal: stretch the tube to %1 times its length and hold it for %2 s</source>
        <translation>Στόχος: τέντωμα του σωλήνα σε %1 φορές το μήκος του και κράτημα για %2 s</translation>
    </message>
    <message>
        <source>Goal: hand over the end of the tube and hold it in the target for %1 s</source>
        <translation>Στόχος: παράδοση του άκρου και κράτημα στον στόχο για %1 s</translation>
    </message>
    <message>
        <source>Instruments: two, one in each hand</source>
        <translation>Εργαλεία: δύο, ένα σε κάθε χέρι</translation>
    </message>
    <message>
        <source>Instruments: one</source>
        <translation>Εργαλεία: ένα</translation>
    </message>
    <message>
        <source>Tube: %1 mm long, gets stiffer as it stretches, tears at %2 times its length</source>
        <translation>Σωλήνας: μήκος %1 mm, γίνεται πιο δύσκαμπτος όσο τεντώνεται, σχίζεται σε μήκος %2 φορές το αρχικό</translation>
    </message>
    <message>
        <source>Tube: %1 mm long, tears at %2 times its length</source>
        <translation>Σωλήνας: μήκος %1 mm, σχίζεται σε μήκος %2 φορές το αρχικό</translation>
    </message>
    <message>
        <source>Hands: two, two fingers each</source>
        <translation>Χέρια: δύο, από δύο δάκτυλα</translation>
    </message>
    <message>
        <source>Hands: two, one finger each</source>
        <translation>Χέρια: δύο, από ένα δάκτυλο</translation>
    </message>
    <message>
        <source>Hands: one, two fingers side by side</source>
        <translation>Χέρια: ένα, δύο δάκτυλα δίπλα δίπλα</translation>
    </message>
    <message>
        <source>Hands: one, one finger</source>
        <translation>Χέρια: ένα, ένα δάκτυλο</translation>
    </message>
    <message>
        <source>Lumps per trial: %1</source>
        <translation>Όζοι ανά δοκιμή: %1</translation>
    </message>
    <message>
        <source>Lumps per trial: one or none</source>
        <translation>Όζοι ανά δοκιμή: ένας ή κανένας</translation>
    </message>
    <message>
        <source>Lumps per trial: 0 to %1</source>
        <translation>Όζοι ανά δοκιμή: 0 έως %1</translation>
    </message>
    <message>
        <source>Lumps per trial: %1 to %2</source>
        <translation>Όζοι ανά δοκιμή: %1 έως %2</translation>
    </message>
    <message>
        <source>where it is</source>
        <translation>πού βρίσκεται</translation>
    </message>
    <message>
        <source>how large</source>
        <translation>πόσο μεγάλος</translation>
    </message>
    <message>
        <source>how hard</source>
        <translation>πόσο σκληρός</translation>
    </message>
    <message>
        <source>how sure you are</source>
        <translation>πόσο βέβαιοι είστε</translation>
    </message>
    <message>
        <source>To report for each finding: %1</source>
        <translation>Για κάθε εύρημα δηλώνεται: %1</translation>
    </message>
    <message>
        <source>Press with %1 to %2 N</source>
        <translation>Πιέστε με %1 έως %2 N</translation>
    </message>
    <message>
        <source>Instruments: three, one in each hand and one that holds tissue back</source>
        <translation>Εργαλεία: τρία, ένα σε κάθε χέρι και ένα που συγκρατεί ιστό</translation>
    </message>
    <message>
        <source>Over the tube: a fold of tissue, to be held back with %1 to %2 N</source>
        <translation>Πάνω από τον σωλήνα: μια πτυχή ιστού που πρέπει να συγκρατείται με %1 έως %2 N</translation>
    </message>
    <message>
        <source>Devices with a base are mounted as this level specifies; your settings below override it</source>
        <translation>Οι συσκευές με βάση τοποθετούνται όπως ορίζει αυτό το επίπεδο· ό,τι ρυθμίσετε παρακάτω υπερισχύει</translation>
    </message>
    <message>
        <source>Goal: put the heaviest of %1 identical-looking objects inside the ring</source>
        <translation>Στόχος: το βαρύτερο από %1 όμοια αντικείμενα να τοποθετηθεί μέσα στον δακτύλιο</translation>
    </message>
    <message>
        <source>Goal: lift the object by %1 mm and put it inside the ring</source>
        <translation>Στόχος: ανύψωση του αντικειμένου κατά %1 mm και τοποθέτηση μέσα στον δακτύλιο</translation>
    </message>
    <message>
        <source>Surface: a soft organ that deforms</source>
        <translation>Βάση: ένα μαλακό όργανο που παραμορφώνεται</translation>
    </message>
    <message>
        <source>Trials: %1; each ends after %2 s at the latest</source>
        <translation>Δοκιμές: %1· η καθεμία τελειώνει το αργότερο μετά από %2 s</translation>
    </message>
    <message>
        <source>The trial ends after %1 s at the latest</source>
        <translation>Η δοκιμή τελειώνει το αργότερο μετά από %1 s</translation>
    </message>
</context>
<context>
    <name>LoginSlips</name>
    <message>
        <source>Name</source>
        <translation>Όνομα</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Κέντρο</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Όνομα χρήστη</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Κωδικός πρόσβασης</translation>
    </message>
    <message>
        <source>At your first login, choose your name in the list, enter this password and then choose one of your own. After that, this slip is of no use: destroy it.</source>
        <translation>Στην πρώτη σύνδεση επιλέξτε το όνομά σας στη λίστα, γράψτε αυτόν τον κωδικό πρόσβασης και έπειτα ορίστε δικό σας. Μετά το σημείωμα αυτό δεν χρειάζεται: καταστρέψτε το.</translation>
    </message>
    <message>
        <source>Login slips</source>
        <translation>Σημειώματα σύνδεσης</translation>
    </message>
    <message>
        <source>Cut along the dashed lines and hand each slip to its person.</source>
        <translation>Κόψτε στις διακεκομμένες γραμμές και δώστε σε κάθε άτομο το σημείωμά του.</translation>
    </message>
</context>
<context>
    <name>Metrics</name>
    <message>
        <source>Procedure completed</source>
        <translation>Ολοκλήρωση της διαδικασίας</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Χρόνος</translation>
    </message>
    <message>
        <source>From the first movement or touch of each trial to its end, added up; pauses do not count.</source>
        <translation>Από την πρώτη κίνηση ή επαφή κάθε δοκιμής ως το τέλος της, αθροιστικά· οι παύσεις δεν μετράνε.</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Μήκος διαδρομής</translation>
    </message>
    <message>
        <source>How far the tip of the tool travelled in all trials together.</source>
        <translation>Πόση απόσταση διένυσε η άκρη του εργαλείου σε όλες τις δοκιμές μαζί.</translation>
    </message>
    <message>
        <source>Path inefficiency</source>
        <translation>Πλεονάζουσα διαδρομή</translation>
    </message>
    <message>
        <source>How much longer the path was than the shortest one: the straight line or, where the route bends, the route itself; the mean over the trials.</source>
        <translation>Πόσο μεγαλύτερη ήταν η διαδρομή από τη συντομότερη: την ευθεία ή, όπου η πορεία κάμπτεται, την ίδια την πορεία· μέσος όρος των δοκιμών.</translation>
    </message>
    <message>
        <source>Smoothness (SPARC)</source>
        <translation>Ομαλότητα (SPARC)</translation>
    </message>
    <message>
        <source>How even the speed of each movement was, calculated from its spectrum. Closer to zero is smoother.</source>
        <translation>Πόσο ομοιόμορφη ήταν η ταχύτητα κάθε κίνησης, υπολογισμένη από το φάσμα της. Πιο κοντά στο μηδέν σημαίνει πιο ομαλή.</translation>
    </message>
    <message>
        <source>Smoothness (LDLJ)</source>
        <translation>Ομαλότητα (LDLJ)</translation>
    </message>
    <message>
        <source>How free of jerks each movement was. Closer to zero is smoother.</source>
        <translation>Πόσο απαλλαγμένη από τινάγματα ήταν κάθε κίνηση. Πιο κοντά στο μηδέν σημαίνει πιο ομαλή.</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Μέγιστη δύναμη</translation>
    </message>
    <message>
        <source>The largest force on the tissue at any moment.</source>
        <translation>Η μεγαλύτερη δύναμη στον ιστό σε οποιαδήποτε στιγμή.</translation>
    </message>
    <message>
        <source>Mean force in contact</source>
        <translation>Μέση δύναμη στην επαφή</translation>
    </message>
    <message>
        <source>The mean force on the tissue while the tool touched it.</source>
        <translation>Η μέση δύναμη στον ιστό όσο τον άγγιζε το εργαλείο.</translation>
    </message>
    <message>
        <source>Force, root mean square</source>
        <translation>Δύναμη, τετραγωνικός μέσος</translation>
    </message>
    <message>
        <source>The root mean square of the force on the tissue: high forces weigh more than in the mean.</source>
        <translation>Ο τετραγωνικός μέσος της δύναμης στον ιστό: οι μεγάλες δυνάμεις βαραίνουν περισσότερο από ό,τι στον μέσο όρο.</translation>
    </message>
    <message>
        <source>Force, 95th percentile</source>
        <translation>Δύναμη, 95ο εκατοστημόριο</translation>
    </message>
    <message>
        <source>The force on the tissue was below this for 95 % of the time.</source>
        <translation>Η δύναμη στον ιστό ήταν κάτω από αυτή την τιμή στο 95 % του χρόνου.</translation>
    </message>
    <message>
        <source>Peak force rate</source>
        <translation>Μέγιστη μεταβολή δύναμης</translation>
    </message>
    <message>
        <source>The fastest rise or fall of the force on the tissue.</source>
        <translation>Η ταχύτερη αύξηση ή μείωση της δύναμης στον ιστό.</translation>
    </message>
    <message>
        <source>Impulse over the limit</source>
        <translation>Ώθηση πάνω από το όριο</translation>
    </message>
    <message>
        <source>Force times time while the force was over the limit of this level.</source>
        <translation>Δύναμη επί χρόνο όσο η δύναμη ήταν πάνω από το όριο αυτού του επιπέδου.</translation>
    </message>
    <message>
        <source>Time over the force limit</source>
        <translation>Χρόνος πάνω από το όριο δύναμης</translation>
    </message>
    <message>
        <source>How long the force on the tissue was over the limit of this level.</source>
        <translation>Πόσο χρόνο η δύναμη στον ιστό ήταν πάνω από το όριο αυτού του επιπέδου.</translation>
    </message>
    <message>
        <source>Apex error, mean</source>
        <translation>Μέσο σφάλμα κορυφής</translation>
    </message>
    <message>
        <source>How far the marks lay from the highest point, in % of the radius; the mean over both axes and all trials, misses included.</source>
        <translation>Πόσο μακριά ήταν τα σημεία από το ψηλότερο σημείο, σε % της ακτίνας· μέσος όρος των δύο αξόνων και όλων των δοκιμών, μαζί με τις αστοχίες.</translation>
    </message>
    <message>
        <source>Apex error, standard deviation</source>
        <translation>Σφάλμα κορυφής, τυπ. απόκλιση</translation>
    </message>
    <message>
        <source>How much the error differed from mark to mark.</source>
        <translation>Πόσο διέφερε το σφάλμα από σημείο σε σημείο.</translation>
    </message>
    <message>
        <source>Apex bias, left to right</source>
        <translation>Μετατόπιση κορυφής, αριστερά-δεξιά</translation>
    </message>
    <message>
        <source>Whether the marks lay to one side: the mean error to the right (positive) or left (negative).</source>
        <translation>Αν τα σημεία ήταν προς τη μία πλευρά: το μέσο σφάλμα δεξιά (θετικό) ή αριστερά (αρνητικό).</translation>
    </message>
    <message>
        <source>Apex bias, front to back</source>
        <translation>Μετατόπιση κορυφής, εμπρός-πίσω</translation>
    </message>
    <message>
        <source>Whether the marks lay to one side: the mean error away from (positive) or towards (negative) the person.</source>
        <translation>Αν τα σημεία ήταν προς τη μία πλευρά: το μέσο σφάλμα μακριά από το άτομο (θετικό) ή προς αυτό (αρνητικό).</translation>
    </message>
    <message>
        <source>Misses</source>
        <translation>Αστοχίες</translation>
    </message>
    <message>
        <source>Trials marked without touching, marked beside the sphere, or not marked in time. Their errors count all the same.</source>
        <translation>Δοκιμές που σημειώθηκαν χωρίς επαφή, έξω από τη σφαίρα ή δεν σημειώθηκαν εγκαίρως. Τα σφάλματά τους μετράνε κανονικά.</translation>
    </message>
    <message>
        <source>the recording has no forces</source>
        <translation>η καταγραφή δεν έχει δυνάμεις</translation>
    </message>
    <message>
        <source>no trials</source>
        <translation>καμία δοκιμή</translation>
    </message>
    <message>
        <source>start and end are less than 5 mm apart</source>
        <translation>αρχή και τέλος απέχουν λιγότερο από 5 mm</translation>
    </message>
    <message>
        <source>fewer than two samples</source>
        <translation>λιγότερα από δύο δείγματα</translation>
    </message>
    <message>
        <source>fewer than two positions</source>
        <translation>λιγότερες από δύο θέσεις</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>καμία επαφή</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>κανένα δείγμα</translation>
    </message>
    <message>
        <source>needs two trials or more</source>
        <translation>χρειάζονται δύο ή περισσότερες δοκιμές</translation>
    </message>
    <message>
        <source>neither movement nor contact</source>
        <translation>ούτε κίνηση ούτε επαφή</translation>
    </message>
    <message>
        <source>no sub-movement of at least 100 ms</source>
        <translation>καμία επιμέρους κίνηση τουλάχιστον 100 ms</translation>
    </message>
    <message>
        <source>no movement</source>
        <translation>καμία κίνηση</translation>
    </message>
    <message>
        <source>speed has no spectrum up to 10 Hz</source>
        <translation>η ταχύτητα δεν έχει φάσμα έως 10 Hz</translation>
    </message>
    <message>
        <source>fewer than three speed samples</source>
        <translation>λιγότερα από τρία δείγματα ταχύτητας</translation>
    </message>
    <message>
        <source>no jerk: speed changes evenly</source>
        <translation>χωρίς τίναγμα: η ταχύτητα αλλάζει ομοιόμορφα</translation>
    </message>
    <message>
        <source>Off-centre distance, root mean square</source>
        <translation>Απόκλιση από τον άξονα, τετραγωνικός μέσος</translation>
    </message>
    <message>
        <source>How far the tip was from the middle of the urethra, on the way in and out: large distances weigh more than in the mean.</source>
        <translation>Πόσο απείχε η άκρη από τον άξονα της ουρήθρας, κατά την εισαγωγή και την απόσυρση: οι μεγάλες αποστάσεις βαραίνουν περισσότερο από ό,τι στον μέσο όρο.</translation>
    </message>
    <message>
        <source>Largest off-centre distance</source>
        <translation>Μέγιστη απόκλιση από τον άξονα</translation>
    </message>
    <message>
        <source>The largest distance of the tip from the middle of the urethra.</source>
        <translation>Η μεγαλύτερη απόσταση της άκρης από τον άξονα της ουρήθρας.</translation>
    </message>
    <message>
        <source>Alignment, root mean square</source>
        <translation>Ευθυγράμμιση, τετραγωνικός μέσος</translation>
    </message>
    <message>
        <source>Alignment at the bend</source>
        <translation>Ευθυγράμμιση στην καμπή</translation>
    </message>
    <message>
        <source>Alignment in the bend</source>
        <translation>Ευθυγράμμιση μέσα στην καμπή</translation>
    </message>
    <message>
        <source>Trauma events</source>
        <translation>Συμβάντα τραυματισμού</translation>
    </message>
    <message>
        <source>Trauma time</source>
        <translation>Διάρκεια τραυματισμού</translation>
    </message>
    <message>
        <source>How long these events lasted in total.</source>
        <translation>Πόσο διήρκεσαν συνολικά αυτά τα συμβάντα.</translation>
    </message>
    <message>
        <source>Trauma impulse</source>
        <translation>Ώθηση τραυματισμού</translation>
    </message>
    <message>
        <source>Sideways force times time while that force was over the limit of this level.</source>
        <translation>Πλάγια δύναμη επί χρόνο όσο η δύναμη αυτή ήταν πάνω από το όριο αυτού του επιπέδου.</translation>
    </message>
    <message>
        <source>Largest sideways force</source>
        <translation>Μέγιστη πλάγια δύναμη</translation>
    </message>
    <message>
        <source>The largest force with which the endoscope pressed sideways on the wall at any moment.</source>
        <translation>Η μεγαλύτερη δύναμη με την οποία το ενδοσκόπιο πίεσε πλάγια το τοίχωμα σε οποιαδήποτε στιγμή.</translation>
    </message>
    <message>
        <source>Advance while turning</source>
        <translation>Προώθηση κατά τη στροφή</translation>
    </message>
    <message>
        <source>How far the endoscope was pushed on in the bend while it was being turned: stop, turn, and only then go on.</source>
        <translation>Πόσο προωθήθηκε το ενδοσκόπιο στην καμπή ενώ στρεφόταν: σταματήστε, στρέψτε και μόνο τότε συνεχίστε.</translation>
    </message>
    <message>
        <source>Largest torque</source>
        <translation>Μέγιστη ροπή</translation>
    </message>
    <message>
        <source>The largest torque between endoscope and tissue at any moment.</source>
        <translation>Η μεγαλύτερη ροπή ανάμεσα στο ενδοσκόπιο και τον ιστό σε οποιαδήποτε στιγμή.</translation>
    </message>
    <message>
        <source>Torque, root mean square</source>
        <translation>Ροπή, τετραγωνικός μέσος</translation>
    </message>
    <message>
        <source>The root mean square of the torque between endoscope and tissue.</source>
        <translation>Ο τετραγωνικός μέσος της ροπής ανάμεσα στο ενδοσκόπιο και τον ιστό.</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>Οπισθοχωρήσεις</translation>
    </message>
    <message>
        <source>How often the tip went back by 1 mm or more on the way in.</source>
        <translation>Πόσες φορές η άκρη οπισθοχώρησε κατά 1 mm ή περισσότερο κατά την εισαγωγή.</translation>
    </message>
    <message>
        <source>Landmarks seen</source>
        <translation>Οδηγά σημεία που φάνηκαν</translation>
    </message>
    <message>
        <source>The landmarks of the bladder that were inspected, in % of those that the level asks for.</source>
        <translation>Τα οδηγά σημεία της κύστης που εξετάστηκαν, σε % όσων ζητά το επίπεδο.</translation>
    </message>
    <message>
        <source>Tip travel during inspection</source>
        <translation>Διαδρομή της άκρης στην επισκόπηση</translation>
    </message>
    <message>
        <source>How far the tip travelled while the bladder was inspected: turning the endoscope shows as much and does less harm.</source>
        <translation>Πόσο μετακινήθηκε η άκρη όσο εξεταζόταν η κύστη: η στροφή του ενδοσκοπίου δείχνει τα ίδια και βλάπτει λιγότερο.</translation>
    </message>
    <message>
        <source>Insertion depth</source>
        <translation>Βάθος εισαγωγής</translation>
    </message>
    <message>
        <source>How deep the tip went, counted up to the goal of this level.</source>
        <translation>Πόσο βαθιά έφτασε η άκρη, με ανώτατη τιμή τον στόχο αυτού του επιπέδου.</translation>
    </message>
    <message>
        <source>the recording has no insertion data</source>
        <translation>η καταγραφή δεν έχει στοιχεία εισαγωγής</translation>
    </message>
    <message>
        <source>the recording has no torques</source>
        <translation>η καταγραφή δεν έχει ροπές</translation>
    </message>
    <message>
        <source>the tip was never in the urethra</source>
        <translation>η άκρη δεν μπήκε ποτέ στην ουρήθρα</translation>
    </message>
    <message>
        <source>the tip was never at the bend</source>
        <translation>η άκρη δεν έφτασε ποτέ στην καμπή</translation>
    </message>
    <message>
        <source>the level has no landmarks</source>
        <translation>το επίπεδο δεν έχει οδηγά σημεία</translation>
    </message>
    <message>
        <source>the inspection was not reached</source>
        <translation>η επισκόπηση δεν ξεκίνησε</translation>
    </message>
    <message>
        <source>published, 5 subjects × 10</source>
        <translation>δημοσιευμένη, 5 άτομα × 10</translation>
    </message>
    <message>
        <source>% of R</source>
        <translation>% ακτίνας</translation>
    </message>
    <message>
        <source>How many of the trials were completed in time, with everything that the level asks for, in %.</source>
        <translation>Πόσες από τις δοκιμές ολοκληρώθηκαν εγκαίρως, με όλα όσα ζητά το επίπεδο, σε %.</translation>
    </message>
    <message>
        <source>Tension error, root mean square</source>
        <translation>Σφάλμα τάσης, τετραγωνικός μέσος</translation>
    </message>
    <message>
        <source>How far the tension of the tube was from its target while it was held: large differences weigh more than in the mean.</source>
        <translation>Πόσο απείχε η τάση του σωλήνα από τον στόχο της κατά το κράτημα: οι μεγάλες αποκλίσεις μετράνε περισσότερο απ&apos; ό,τι στον μέσο όρο.</translation>
    </message>
    <message>
        <source>Tension error, standard deviation</source>
        <translation>Σφάλμα τάσης, τυπική απόκλιση</translation>
    </message>
    <message>
        <source>How unsteady the tension of the tube was while it was held, whether on target or not.</source>
        <translation>Πόσο ασταθής ήταν η τάση του σωλήνα κατά το κράτημα, στον στόχο ή έξω από αυτόν.</translation>
    </message>
    <message>
        <source>Time in the band</source>
        <translation>Χρόνος στη ζώνη</translation>
    </message>
    <message>
        <source>How long the tension, or the length at the mark, stayed in its band during the hold; the mean over all trials.</source>
        <translation>Πόση ώρα κατά το κράτημα η τάση, ή το μήκος στο σημάδι, ήταν μέσα στη ζώνη· μέσος όρος όλων των δοκιμών.</translation>
    </message>
    <message>
        <source>Critical errors</source>
        <translation>Κρίσιμα σφάλματα</translation>
    </message>
    <message>
        <source>How often the tissue gave way because it was pushed or turned too hard, or was pressed sideways too hard or for too long.</source>
        <translation>Πόσες φορές ο ιστός υποχώρησε επειδή πιέστηκε ή στράφηκε υπερβολικά, ή πιέστηκε πλάγια υπερβολικά ή για πολλή ώρα.</translation>
    </message>
    <message>
        <source>Over-stretches</source>
        <translation>Υπερτεντώματα</translation>
    </message>
    <message>
        <source>How often the tube was stretched beyond the limit of this level.</source>
        <translation>Πόσες φορές ο σωλήνας τεντώθηκε πέρα από το όριο αυτού του επιπέδου.</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Απώλειες λαβής</translation>
    </message>
    <message>
        <source>How often the tissue was let go of before the task was done.</source>
        <translation>Πόσες φορές ο ιστός αφέθηκε πριν ολοκληρωθεί η εργασία.</translation>
    </message>
    <message>
        <source>Largest squeeze</source>
        <translation>Μέγιστη σύσφιξη</translation>
    </message>
    <message>
        <source>The largest force with which the jaws squeezed what they held.</source>
        <translation>Η μεγαλύτερη δύναμη με την οποία οι σιαγόνες έσφιξαν αυτό που κρατούσαν.</translation>
    </message>
    <message>
        <source>Time squeezing too hard</source>
        <translation>Χρόνος υπερβολικής σύσφιξης</translation>
    </message>
    <message>
        <source>How long the squeeze was over the limit of this level.</source>
        <translation>Πόση ώρα η σύσφιξη ήταν πάνω από το όριο αυτού του επιπέδου.</translation>
    </message>
    <message>
        <source>Placement error</source>
        <translation>Σφάλμα τοποθέτησης</translation>
    </message>
    <message>
        <source>How far from the middle of the target the object lay at the end of each trial; the mean over the trials.</source>
        <translation>Πόσο μακριά από το κέντρο του στόχου βρισκόταν το αντικείμενο στο τέλος κάθε δοκιμής· μέσος όρος των δοκιμών.</translation>
    </message>
    <message>
        <source>Heaviest found</source>
        <translation>Εύρεση του βαρύτερου</translation>
    </message>
    <message>
        <source>How often the heaviest object was put into the target, in % of the trials.</source>
        <translation>Πόσο συχνά το βαρύτερο αντικείμενο τοποθετήθηκε στον στόχο, σε % των δοκιμών.</translation>
    </message>
    <message>
        <source>the recording has no procedure</source>
        <translation>η καταγραφή δεν έχει διαδικασία</translation>
    </message>
    <message>
        <source>the recording has no squeeze</source>
        <translation>η καταγραφή δεν έχει σύσφιξη</translation>
    </message>
    <message>
        <source>the recording has no squeeze limit</source>
        <translation>η καταγραφή δεν έχει όριο σύσφιξης</translation>
    </message>
    <message>
        <source>the recording has neither objects nor a target</source>
        <translation>η καταγραφή δεν έχει ούτε αντικείμενα ούτε στόχο</translation>
    </message>
    <message>
        <source>the level asks for no weighing</source>
        <translation>το επίπεδο δεν ζητά ζύγισμα</translation>
    </message>
    <message>
        <source>the recording has no tube data</source>
        <translation>η καταγραφή δεν έχει στοιχεία σωλήνα</translation>
    </message>
    <message>
        <source>the task has no such target</source>
        <translation>η εργασία δεν έχει τέτοιον στόχο</translation>
    </message>
    <message>
        <source>the tension was never held</source>
        <translation>η τάση δεν κρατήθηκε ποτέ</translation>
    </message>
    <message>
        <source>Lumps found</source>
        <translation>Όζοι που βρέθηκαν</translation>
    </message>
    <message>
        <source>Lumps with a finding close enough to count. A lump that was pressed harder than the limit does not count.</source>
        <translation>Όζοι με αρκετά κοντινό εύρημα. Ένας όζος που πιέστηκε πάνω από το όριο δεν μετρά.</translation>
    </message>
    <message>
        <source>Lumps missed</source>
        <translation>Όζοι που διέφυγαν</translation>
    </message>
    <message>
        <source>Lumps with no finding close enough to count.</source>
        <translation>Όζοι χωρίς αρκετά κοντινό εύρημα.</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>Ψευδείς συναγερμοί</translation>
    </message>
    <message>
        <source>Findings where there was no lump; a second finding of the same lump counts too.</source>
        <translation>Ευρήματα όπου δεν υπήρχε όζος· μετρά και δεύτερο εύρημα του ίδιου όζου.</translation>
    </message>
    <message>
        <source>Sensitivity (d′)</source>
        <translation>Ευαισθησία (d′)</translation>
    </message>
    <message>
        <source>How well places with a lump were told apart from places without, whatever the tendency to say yes or no. 0 is chance.</source>
        <translation>Πόσο καλά διακρίθηκαν θέσεις με και χωρίς όζο, ανεξάρτητα από την τάση για ναι ή όχι. Το 0 αντιστοιχεί στην τύχη.</translation>
    </message>
    <message>
        <source>Criterion (c)</source>
        <translation>Κριτήριο (c)</translation>
    </message>
    <message>
        <source>The tendency when in doubt: to report a lump (negative) or not to report one (positive).</source>
        <translation>Η τάση σε περίπτωση αμφιβολίας: να αναφερθεί όζος (αρνητικό) ή να μην αναφερθεί (θετικό).</translation>
    </message>
    <message>
        <source>Area under the ROC curve</source>
        <translation>Εμβαδόν κάτω από την καμπύλη ROC</translation>
    </message>
    <message>
        <source>How well confidence tells places with a lump from places without: 0.5 is chance, 1 is perfect.</source>
        <translation>Πόσο καλά η βεβαιότητα διακρίνει θέσεις με και χωρίς όζο: το 0,5 αντιστοιχεί στην τύχη, το 1 είναι τέλειο.</translation>
    </message>
    <message>
        <source>Localisation error</source>
        <translation>Σφάλμα εντοπισμού</translation>
    </message>
    <message>
        <source>How far, on the surface, each finding was from the lump that it found; the mean over all lumps found.</source>
        <translation>Πόσο απείχαν τα ευρήματα από τους όζους τους στην επιφάνεια· μέσος όρος όλων όσων βρέθηκαν.</translation>
    </message>
    <message>
        <source>Size error</source>
        <translation>Σφάλμα μεγέθους</translation>
    </message>
    <message>
        <source>How far the stated radius was from the true one; the mean over all lumps found with a stated size.</source>
        <translation>Πόσο απείχε η δηλωμένη ακτίνα από την πραγματική· μέσος όρος των όζων που βρέθηκαν και δηλώθηκε το μέγεθός τους.</translation>
    </message>
    <message>
        <source>Sensitivity, lower bound</source>
        <translation>Ευαισθησία, κάτω όριο</translation>
    </message>
    <message>
        <source>Sensitivity, upper bound</source>
        <translation>Ευαισθησία, άνω όριο</translation>
    </message>
    <message>
        <source>The upper end of the 95 % interval of the sensitivity.</source>
        <translation>Το άνω άκρο του διαστήματος 95 % της ευαισθησίας.</translation>
    </message>
    <message>
        <source>Prediction error at 30 Hz</source>
        <translation>Σφάλμα πρόβλεψης στα 30 Hz</translation>
    </message>
    <message>
        <source>How far the predicted soft surface under the tool was from the result of the slow model; this rates the simulation, not you.</source>
        <translation>Πόσο απείχε η προβλεπόμενη μαλακή επιφάνεια κάτω από το εργαλείο από το αποτέλεσμα του αργού μοντέλου· αξιολογεί την προσομοίωση, όχι εσάς.</translation>
    </message>
    <message>
        <source>Error without prediction</source>
        <translation>Σφάλμα χωρίς πρόβλεψη</translation>
    </message>
    <message>
        <source>The same error if the last update had been kept instead: the difference shows what the prediction is worth.</source>
        <translation>Το ίδιο σφάλμα αν είχε διατηρηθεί η τελευταία ενημέρωση: η διαφορά δείχνει πόσο αξίζει η πρόβλεψη.</translation>
    </message>
    <message>
        <source>no trial was finished</source>
        <translation>καμία δοκιμή δεν ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>the trial was not finished</source>
        <translation>η δοκιμή δεν ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>there is no chance level for a single trial</source>
        <translation>για μία μόνο δοκιμή δεν υπάρχει επίπεδο τύχης</translation>
    </message>
    <message>
        <source>no two lumps of different hardness were found and rated</source>
        <translation>δεν βρέθηκαν και δεν βαθμολογήθηκαν δύο όζοι διαφορετικής σκληρότητας</translation>
    </message>
    <message>
        <source>fewer than two lumps were found and given a hardness</source>
        <translation>βρέθηκαν λιγότεροι από δύο όζοι με δηλωμένη σκληρότητα</translation>
    </message>
    <message>
        <source>there were fewer than two lumps</source>
        <translation>υπήρχαν λιγότεροι από δύο όζοι</translation>
    </message>
    <message>
        <source>nothing was touched, so nothing was predicted</source>
        <translation>δεν αγγίχτηκε τίποτα, άρα δεν προβλέφθηκε τίποτα</translation>
    </message>
    <message>
        <source>the recording has no prediction</source>
        <translation>η καταγραφή δεν περιέχει πρόβλεψη</translation>
    </message>
    <message>
        <source>Heaviest found by chance</source>
        <translation>Εύρεση του βαρύτερου κατά τύχη</translation>
    </message>
    <message>
        <source>Localisation error by chance</source>
        <translation>Σφάλμα εντοπισμού κατά τύχη</translation>
    </message>
    <message>
        <source>How far findings would be from a lump if they hit it at random. A localisation error that is not smaller shows no skill.</source>
        <translation>Πόσο θα απείχαν τα ευρήματα από έναν όζο αν τον πετύχαιναν τυχαία. Ένα σφάλμα εντοπισμού που δεν είναι μικρότερο δεν δείχνει δεξιότητα.</translation>
    </message>
    <message>
        <source>Hardness order by chance</source>
        <translation>Σειρά σκληρότητας κατά τύχη</translation>
    </message>
    <message>
        <source>The hardness order of somebody who assigns the same hardness ratings to the lumps at random. A share that is not larger shows no skill.</source>
        <translation>Η σειρά σκληρότητας κάποιου που αποδίδει στους όζους τις ίδιες σκληρότητες στην τύχη. Ένα ποσοστό που δεν είναι μεγαλύτερο δεν δείχνει δεξιότητα.</translation>
    </message>
    <message>
        <source>Apex error by chance</source>
        <translation>Σφάλμα κορυφής κατά τύχη</translation>
    </message>
    <message>
        <source>Size error by chance</source>
        <translation>Σφάλμα μεγέθους κατά τύχη</translation>
    </message>
    <message>
        <source>Hardness order</source>
        <translation>Σειρά σκληρότητας</translation>
    </message>
    <message>
        <source>How often the harder of two lumps found in a trial was also rated harder, in % of all such pairs. Guessing gives 50 % or less.</source>
        <translation>Πόσο συχνά ο σκληρότερος από δύο όζους που βρέθηκαν σε μια δοκιμή δηλώθηκε και σκληρότερος, σε % αυτών των ζευγών. Κατά τύχη είναι το πολύ 50 %.</translation>
    </message>
    <message>
        <source>Area covered</source>
        <translation>Καλυμμένη περιοχή</translation>
    </message>
    <message>
        <source>How much of the search area was pressed hard enough to find something; the mean over the trials.</source>
        <translation>Πόσο μέρος της περιοχής αναζήτησης πιέστηκε αρκετά δυνατά για να βρεθεί κάτι· μέσος όρος των δοκιμών.</translation>
    </message>
    <message>
        <source>Time in the force band</source>
        <translation>Χρόνος στη ζώνη δύναμης</translation>
    </message>
    <message>
        <source>During how much of the pressing time the force was neither too low nor too high.</source>
        <translation>Σε πόσο μέρος του χρόνου πίεσης η δύναμη δεν ήταν ούτε πολύ μικρή ούτε πολύ μεγάλη.</translation>
    </message>
    <message>
        <source>Time pressing</source>
        <translation>Χρόνος πίεσης</translation>
    </message>
    <message>
        <source>How long a finger pressed the tissue, in all trials together.</source>
        <translation>Πόση ώρα κάποιο δάκτυλο πίεζε τον ιστό, σε όλες τις δοκιμές μαζί.</translation>
    </message>
    <message>
        <source>Time searching</source>
        <translation>Χρόνος αναζήτησης</translation>
    </message>
    <message>
        <source>How long the trials took until the search was reported as done; pauses do not count.</source>
        <translation>Πόσο διήρκεσαν οι δοκιμές μέχρι να δηλωθεί το τέλος· οι παύσεις δεν μετρούν.</translation>
    </message>
    <message>
        <source>the recording has neither lumps nor a search area</source>
        <translation>η καταγραφή δεν έχει ούτε όζους ούτε περιοχή αναζήτησης</translation>
    </message>
    <message>
        <source>the recording has no reports</source>
        <translation>η καταγραφή δεν έχει αναφορές</translation>
    </message>
    <message>
        <source>reports are missing from the recording</source>
        <translation>στην καταγραφή λείπουν αναφορές</translation>
    </message>
    <message>
        <source>there was no lump</source>
        <translation>δεν υπήρχε όζος</translation>
    </message>
    <message>
        <source>no lump was found</source>
        <translation>δεν βρέθηκε όζος</translation>
    </message>
    <message>
        <source>no finding has a confidence rating</source>
        <translation>για κανένα εύρημα δεν δηλώθηκε βεβαιότητα</translation>
    </message>
    <message>
        <source>the level asks for no size</source>
        <translation>το επίπεδο δεν ζητά μέγεθος</translation>
    </message>
    <message>
        <source>the level asks for no hardness</source>
        <translation>το επίπεδο δεν ζητά σκληρότητα</translation>
    </message>
    <message>
        <source>in no trial were two lumps found and given a hardness</source>
        <translation>σε καμία δοκιμή δεν βρέθηκαν δύο όζοι με δηλωμένη σκληρότητα</translation>
    </message>
    <message>
        <source>the lumps that were found are equally hard</source>
        <translation>οι όζοι που βρέθηκαν είναι εξίσου σκληροί</translation>
    </message>
    <message>
        <source>the recording has no coverage data</source>
        <translation>η καταγραφή δεν έχει στοιχεία κάλυψης</translation>
    </message>
    <message>
        <source>the recording has no force band</source>
        <translation>η καταγραφή δεν έχει ζώνη δύναμης</translation>
    </message>
    <message>
        <source>nothing was pressed</source>
        <translation>δεν πιέστηκε τίποτα</translation>
    </message>
    <message>
        <source>only %1 regions with a lump and %2 without: %3 of each are needed</source>
        <translation>μόνο %1 περιοχές με όζο και %2 χωρίς: χρειάζονται %3 από καθεμία</translation>
    </message>
    <message>
        <source>Retraction in the band</source>
        <translation>Έλξη της πτυχής μέσα στη ζώνη</translation>
    </message>
    <message>
        <source>How much of the time the pull on the fold of tissue was in its band, once the fold was held back, in %; the mean over all trials.</source>
        <translation>Για πόσο μέρος του χρόνου, αφότου συγκρατήθηκε η πτυχή ιστού, η έλξη της ήταν μέσα στη ζώνη, σε %· μέσος όρος όλων των δοκιμών.</translation>
    </message>
    <message>
        <source>Largest retraction</source>
        <translation>Μέγιστη έλξη της πτυχής</translation>
    </message>
    <message>
        <source>The largest pull on the fold of tissue at any moment.</source>
        <translation>Η μέγιστη έλξη στην πτυχή ιστού σε οποιαδήποτε στιγμή.</translation>
    </message>
    <message>
        <source>no position to score</source>
        <translation>δεν υπάρχει θέση για βαθμολόγηση</translation>
    </message>
    <message>
        <source>the true position of the apex is not known</source>
        <translation>η αληθινή θέση της κορυφής δεν είναι γνωστή</translation>
    </message>
    <message>
        <source>Apex error</source>
        <translation>Σφάλμα κορυφής</translation>
    </message>
    <message>
        <source>How far the mark lay from the highest point, in % of the radius, averaged over left–right and front–back.</source>
        <translation>Πόσο απείχε το σημείο από την κορυφή, σε % της ακτίνας, κατά μέσο όρο στις διευθύνσεις αριστερά–δεξιά και εμπρός–πίσω.</translation>
    </message>
    <message>
        <source>Largest misalignment</source>
        <translation>Μέγιστη απόκλιση ευθυγράμμισης</translation>
    </message>
    <message>
        <source>The angle between the endoscope and the direction of the urethra where its tip was; large angles weigh more. In the picture: when the two are in line, the wall near the tip is equally wide all round, and a guide ring, where there is one, is drawn double. In a bend the urethra then continues beside the middle of the picture.</source>
        <translation>Η γωνία ανάμεσα στο ενδοσκόπιο και τη διεύθυνση της ουρήθρας εκεί που ήταν η άκρη του· οι μεγάλες γωνίες βαραίνουν περισσότερο. Στην εικόνα: όταν τα δύο ευθυγραμμίζονται, το τοίχωμα κοντά στην άκρη είναι εξίσου πλατύ ολόγυρα και ο δακτύλιος καθοδήγησης, όπου υπάρχει, φαίνεται διπλός. Σε μια καμπή η ουρήθρα συνεχίζει τότε δίπλα στο κέντρο της εικόνας.</translation>
    </message>
    <message>
        <source>How often somebody who perceives nothing would choose the heaviest object. A share that is not larger shows no skill.</source>
        <translation>Πόσο συχνά θα επέλεγε το βαρύτερο αντικείμενο κάποιος που δεν αντιλαμβάνεται τίποτα. Ένα ποσοστό που δεν είναι μεγαλύτερο δεν δείχνει δεξιότητα.</translation>
    </message>
    <message>
        <source>The lower end of the 95 % interval of the sensitivity. Below 0 the session does not show that any lump was perceived.</source>
        <translation>Το κάτω άκρο του διαστήματος 95 % της ευαισθησίας. Κάτω από 0 η συνεδρία δεν δείχνει ότι έγινε αντιληπτός κάποιος όζος.</translation>
    </message>
    <message>
        <source>The size error of somebody who perceives nothing and always states the middle size. A size error that is not smaller shows no skill.</source>
        <translation>Το σφάλμα μεγέθους κάποιου που δεν αντιλαμβάνεται τίποτα και δηλώνει πάντα το μεσαίο μέγεθος. Ένα σφάλμα μεγέθους που δεν είναι μικρότερο δεν δείχνει δεξιότητα.</translation>
    </message>
    <message>
        <source>The apex error of somebody who perceives nothing and always marks the same, best possible place. An error that is not smaller shows no skill.</source>
        <translation>Το σφάλμα κορυφής κάποιου που δεν αντιλαμβάνεται τίποτα και σημειώνει πάντα το ίδιο, το καλύτερο δυνατό, σημείο. Ένα σφάλμα που δεν είναι μικρότερο δεν δείχνει δεξιότητα.</translation>
    </message>
    <message>
        <source>The angle between the endoscope and the urethra at its tip, on the way in, within 10 mm of the bend, where the endoscope has to be turned. When the two are in line, the wall near the tip is equally wide all round.</source>
        <translation>Η γωνία ανάμεσα στο ενδοσκόπιο και την ουρήθρα εκεί που ήταν η άκρη του, κατά την εισαγωγή, ως 10 mm από την καμπή, όπου το ενδοσκόπιο πρέπει να στραφεί. Όταν ευθυγραμμίζονται, το τοίχωμα κοντά στην άκρη είναι εξίσου πλατύ ολόγυρα.</translation>
    </message>
    <message>
        <source>The angle between the endoscope and the urethra at its tip, on the way in, from the bend to 30 mm past it, where the urethra is curved most. When the two are in line, the wall near the tip is equally wide all round.</source>
        <translation>Η γωνία ανάμεσα στο ενδοσκόπιο και την ουρήθρα εκεί που ήταν η άκρη του, κατά την εισαγωγή, από την καμπή ως 30 mm μετά, όπου η ουρήθρα καμπυλώνει περισσότερο. Όταν ευθυγραμμίζονται, το τοίχωμα κοντά στην άκρη είναι εξίσου πλατύ ολόγυρα.</translation>
    </message>
    <message>
        <source>none of the lumps found was given a size</source>
        <translation>για κανέναν όζο που βρέθηκε δεν δηλώθηκε μέγεθος</translation>
    </message>
    <message>
        <source>How often the endoscope pressed sideways on the wall over the limit of this level for 20 ms or longer. Each time is a trauma event: it may injure the wall.</source>
        <translation>Πόσες φορές το ενδοσκόπιο πίεσε πλάγια το τοίχωμα πάνω από το όριο αυτού του επιπέδου για 20 ms ή περισσότερο. Κάθε φορά είναι ένα συμβάν τραυματισμού: μπορεί να τραυματίσει το τοίχωμα.</translation>
    </message>
    <message>
        <source>All landmarks are seen</source>
        <translation>Φαίνονται όλα τα οδηγά σημεία</translation>
    </message>
    <message>
        <source>The procedure is completed</source>
        <translation>Η διαδικασία ολοκληρώνεται</translation>
    </message>
</context>
<context>
    <name>MomentWords</name>
    <message>
        <source>%1 before the start</source>
        <translation>%1 πριν από την έναρξη</translation>
    </message>
    <message>
        <source>Trial %1, %2</source>
        <translation>Δοκιμή %1, %2</translation>
    </message>
</context>
<context>
    <name>PaletteSearch</name>
    <message>
        <source>%1, level %2: %3</source>
        <translation>%1, επίπεδο %2: %3</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Session %1: %2, level %3, %4, %5</source>
        <translation>Συνεδρία %1: %2, επίπεδο %3, %4, %5</translation>
    </message>
</context>
<context>
    <name>PalpationFindings</name>
    <message>
        <source>stated size %1, true size %2</source>
        <translation>δηλωμένο μέγεθος %1, πραγματικό %2</translation>
    </message>
    <message>
        <source>stated hardness %1, true hardness %2</source>
        <translation>δηλωμένη σκληρότητα %1, πραγματική %2</translation>
    </message>
    <message>
        <source>confidence: %1</source>
        <translation>βεβαιότητα: %1</translation>
    </message>
    <message>
        <source>Lump %1 (%2, %3 mm deep): missed</source>
        <translation>Όζος %1 (%2, βάθος %3 mm): διέφυγε</translation>
    </message>
    <message>
        <source>Lump %1: found, finding %2, %3 mm from its centre</source>
        <translation>Όζος %1: βρέθηκε, εύρημα %2, %3 mm από το κέντρο του</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1· %2</translation>
    </message>
    <message>
        <source>There was no lump, and none was reported.</source>
        <translation>Δεν υπήρχε όζος και δεν αναφέρθηκε κανένας.</translation>
    </message>
    <message>
        <source>There was no lump.</source>
        <translation>Δεν υπήρχε όζος.</translation>
    </message>
    <message>
        <source>Lumps found: %1 of %2.</source>
        <translation>Όζοι που βρέθηκαν: %1 από %2.</translation>
    </message>
    <message>
        <source>Findings where there was no lump: %1.</source>
        <translation>Ευρήματα όπου δεν υπήρχε όζος: %1.</translation>
    </message>
    <message>
        <source>Searched: %1 %.</source>
        <translation>Ερευνήθηκε: %1 %.</translation>
    </message>
    <message>
        <source>Time was up before the search was reported as done.</source>
        <translation>Ο χρόνος τελείωσε πριν δηλωθεί το τέλος της αναζήτησης.</translation>
    </message>
    <message>
        <source>Finding %1: no lump there; the nearest was %2 mm away</source>
        <translation>Εύρημα %1: εκεί δεν υπήρχε όζος· ο πλησιέστερος απείχε %2 mm</translation>
    </message>
    <message>
        <source>Finding %1: no lump there</source>
        <translation>Εύρημα %1: εκεί δεν υπήρχε όζος</translation>
    </message>
</context>
<context>
    <name>PalpationWords</name>
    <message>
        <source>size</source>
        <translation>μέγεθος</translation>
    </message>
    <message>
        <source>hardness</source>
        <translation>σκληρότητα</translation>
    </message>
    <message>
        <source>confidence</source>
        <translation>βεβαιότητα</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>μαλακός</translation>
    </message>
    <message>
        <source>rather soft</source>
        <translation>μάλλον μαλακός</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>μέτριος</translation>
    </message>
    <message>
        <source>firm</source>
        <translation>σκληρός</translation>
    </message>
    <message>
        <source>stony hard</source>
        <translation>πετρώδης</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>δεν δηλώθηκε</translation>
    </message>
    <message>
        <source>a guess</source>
        <translation>εικασία</translation>
    </message>
    <message>
        <source>unsure</source>
        <translation>αβέβαιο</translation>
    </message>
    <message>
        <source>fairly sure</source>
        <translation>αρκετά βέβαιο</translation>
    </message>
    <message>
        <source>sure</source>
        <translation>βέβαιο</translation>
    </message>
    <message>
        <source>certain</source>
        <translation>απολύτως βέβαιο</translation>
    </message>
    <message>
        <source>%1 mm across</source>
        <translation>διάμετρος %1 mm</translation>
    </message>
    <message>
        <source>size not given</source>
        <translation>δεν δηλώθηκε μέγεθος</translation>
    </message>
    <message>
        <source>hardness not given</source>
        <translation>δεν δηλώθηκε σκληρότητα</translation>
    </message>
    <message>
        <source>confidence not given</source>
        <translation>δεν δηλώθηκε βεβαιότητα</translation>
    </message>
    <message>
        <source>Finding %1</source>
        <translation>Εύρημα %1</translation>
    </message>
    <message>
        <source>Finding %1: %2</source>
        <translation>Εύρημα %1: %2</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>Δάκτυλο</translation>
    </message>
    <message>
        <source>Middle finger</source>
        <translation>Μέσος</translation>
    </message>
    <message>
        <source>Index finger</source>
        <translation>Δείκτης</translation>
    </message>
    <message>
        <source>Right middle finger</source>
        <translation>Δεξιός μέσος</translation>
    </message>
    <message>
        <source>Right index finger</source>
        <translation>Δεξιός δείκτης</translation>
    </message>
    <message>
        <source>Left middle finger</source>
        <translation>Αριστερός μέσος</translation>
    </message>
    <message>
        <source>Left index finger</source>
        <translation>Αριστερός δείκτης</translation>
    </message>
</context>
<context>
    <name>ParticipantFacts</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, differences of %3 to %4</source>
        <translation>%1: %2, διαφορές από %3 έως %4</translation>
    </message>
    <message>
        <source>Mark the highest point.</source>
        <translation>Σημειώστε το ψηλότερο σημείο.</translation>
    </message>
    <message>
        <source>as many as the answers need</source>
        <translation>όσες απαιτούν οι απαντήσεις</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>το πολύ %1</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n for practice</source>
        <translation>
            <numerusform>%1 και %n για εξάσκηση</numerusform>
            <numerusform>%1 και %n για εξάσκηση</numerusform>
        </translation>
    </message>
    <message>
        <source>as long as the answers take</source>
        <translation>όσο διαρκούν οι απαντήσεις</translation>
    </message>
    <message>
        <source>none</source>
        <translation>όχι</translation>
    </message>
    <message>
        <source>after every %1 trials, at least %2 s</source>
        <translation>μετά από κάθε %1 δοκιμές, τουλάχιστον %2 s</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>χωρίς όριο</translation>
    </message>
    <message>
        <source>%1 s per trial</source>
        <translation>%1 s ανά δοκιμή</translation>
    </message>
    <message>
        <source>%1 s to explore, then %2 s to answer</source>
        <translation>%1 s για εξερεύνηση, έπειτα %2 s για απάντηση</translation>
    </message>
    <message>
        <source>%1 s to explore, no limit to answer</source>
        <translation>%1 s για εξερεύνηση, χωρίς όριο για απάντηση</translation>
    </message>
    <message>
        <source>after each trial</source>
        <translation>μετά από κάθε δοκιμή</translation>
    </message>
    <message>
        <source>in practice only</source>
        <translation>μόνο στην εξάσκηση</translation>
    </message>
    <message>
        <source>%1 before, %2 after</source>
        <translation>%1 πριν, %2 μετά</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Συνθήκες</translation>
    </message>
    <message>
        <source>Asked</source>
        <translation>Ερώτηση</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Δοκιμές</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Διάρκεια</translation>
    </message>
    <message>
        <source>Breaks</source>
        <translation>Διαλείμματα</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Χρόνος</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Ανατροφοδότηση</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Ερωτήσεις</translation>
    </message>
    <message>
        <source>%1 before, %2 after each condition, %3 after</source>
        <translation>%1 πριν, %2 μετά από κάθε συνθήκη, %3 μετά</translation>
    </message>
    <message>
        <source>%1 in each condition, %2 in all</source>
        <translation>%1 σε κάθε συνθήκη, %2 συνολικά</translation>
    </message>
    <message>
        <source>%1 in all (by condition: %2)</source>
        <translation>%1 συνολικά (ανά συνθήκη: %2)</translation>
    </message>
    <message>
        <source>instructions, controls, a free minute, practice (%1), then the trials that count</source>
        <translation>οδηγίες, χειρισμός, ένα ελεύθερο λεπτό, εξάσκηση (%1), έπειτα οι δοκιμές που μετρούν</translation>
    </message>
    <message>
        <source>instructions, controls, a free minute, then the trials that count</source>
        <translation>οδηγίες, χειρισμός, ένα ελεύθερο λεπτό, έπειτα οι δοκιμές που μετρούν</translation>
    </message>
    <message>
        <source>Sequence in each condition</source>
        <translation>Σειρά σε κάθε συνθήκη</translation>
    </message>
    <message>
        <source>about %1 min for all trials, if each takes %2 s</source>
        <translation>περίπου %1 λεπτά για όλες τις δοκιμές, αν η καθεμία διαρκεί %2 s</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 έως %2</translation>
    </message>
</context>
<context>
    <name>ParticipantProgress</name>
    <message>
        <source>interrupted, %1</source>
        <translation>διακόπηκε, %1</translation>
    </message>
    <message>
        <source>interrupted at trial %1 of at most %2</source>
        <translation>διακόπηκε στη δοκιμή %1 (το πολύ %2)</translation>
    </message>
    <message>
        <source>interrupted at trial %1</source>
        <translation>διακόπηκε στη δοκιμή %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>διακόπηκε</translation>
    </message>
    <message>
        <source>broken off when the participant withdrew</source>
        <translation>σταμάτησε όταν αποσύρθηκε ο συμμετέχων</translation>
    </message>
    <message>
        <source>not begun, and the study is closed</source>
        <translation>δεν ξεκίνησε και η μελέτη έχει κλείσει</translation>
    </message>
    <message>
        <source>not begun yet</source>
        <translation>δεν έχει ξεκινήσει ακόμη</translation>
    </message>
    <message>
        <source>This participant is simulated: its runs are made on the command line.</source>
        <translation>Αυτός ο συμμετέχων είναι προσομοιωμένος: οι εκτελέσεις του γίνονται στη γραμμή εντολών.</translation>
    </message>
    <message>
        <source>Bring the study back from the archive before this participant goes on.</source>
        <translation>Επαναφέρετε τη μελέτη από το αρχείο πριν συνεχίσει αυτός ο συμμετέχων.</translation>
    </message>
    <message>
        <source>Record the consent. Then the first condition can begin.</source>
        <translation>Καταγράψτε τη συγκατάθεση. Έπειτα μπορεί να ξεκινήσει η πρώτη συνθήκη.</translation>
    </message>
    <message>
        <source>Press Run and resume “%1” at the trial where it stopped. If this participant does not come back, withdraw them: what they did is kept.</source>
        <translation>Πατήστε «Διεξαγωγή» και συνεχίστε τη συνθήκη «%1» από τη δοκιμή όπου σταμάτησε. Αν ο συμμετέχων δεν επιστρέψει, αποσύρετέ τον: όσα έκανε διατηρούνται.</translation>
    </message>
    <message>
        <source>“%1” can no longer be started, because the study is closed. The conditions that are done count.</source>
        <translation>Η συνθήκη «%1» δεν μπορεί πια να ξεκινήσει, επειδή η μελέτη έχει κλείσει. Οι συνθήκες που ολοκληρώθηκαν μετρούν.</translation>
    </message>
    <message>
        <source>Press Run and begin “%1”.</source>
        <translation>Πατήστε «Διεξαγωγή» και ξεκινήστε τη συνθήκη «%1».</translation>
    </message>
    <message>
        <source>Every condition is done. The questionnaire “%1” is not answered yet.</source>
        <translation>Όλες οι συνθήκες ολοκληρώθηκαν. Το ερωτηματολόγιο «%1» δεν έχει απαντηθεί ακόμη.</translation>
    </message>
    <message>
        <source>Nothing is left to do: this participant has done everything.</source>
        <translation>Δεν απομένει τίποτα: αυτός ο συμμετέχων τα έκανε όλα.</translation>
    </message>
    <message>
        <source>Nothing is left to do: this participant has withdrawn. If somebody else is to take their place, enrol that person.</source>
        <translation>Δεν απομένει τίποτα: αυτός ο συμμετέχων έχει αποσυρθεί. Αν θα πάρει κάποιος άλλος τη θέση του, εγγράψτε τον.</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>ολοκληρώθηκαν %1 από %2</translation>
    </message>
    <message>
        <source>%1, one interrupted</source>
        <translation>%1, μία διακόπηκε</translation>
    </message>
    <message>
        <source>%1, one broken off</source>
        <translation>%1, μία σταμάτησε</translation>
    </message>
    <message>
        <source>not begun before the participant withdrew</source>
        <translation>δεν ξεκίνησε πριν αποσυρθεί ο συμμετέχων</translation>
    </message>
    <message>
        <source>%1, with questions to answer</source>
        <translation>%1, με ερωτήσεις προς απάντηση</translation>
    </message>
    <message>
        <source>The questionnaire “%1” is not answered yet.</source>
        <translation>Το ερωτηματολόγιο «%1» δεν έχει απαντηθεί ακόμη.</translation>
    </message>
</context>
<context>
    <name>ParticipantSentences</name>
    <message>
        <source>In each trial you explore three objects and put them in order.</source>
        <translation>Σε κάθε δοκιμή εξερευνάτε τρία αντικείμενα και τα βάζετε σε σειρά.</translation>
    </message>
    <message>
        <source>In each trial you explore two objects and choose one of two answers.</source>
        <translation>Σε κάθε δοκιμή εξερευνάτε δύο αντικείμενα και επιλέγετε μία από δύο απαντήσεις.</translation>
    </message>
    <message>
        <source>In each trial you explore three objects and choose one of three answers.</source>
        <translation>Σε κάθε δοκιμή εξερευνάτε τρία αντικείμενα και επιλέγετε μία από τρεις απαντήσεις.</translation>
    </message>
    <message>
        <source>In each trial you explore one object and give it a number.</source>
        <translation>Σε κάθε δοκιμή εξερευνάτε ένα αντικείμενο και του δίνετε έναν αριθμό.</translation>
    </message>
    <message numerus="yes">
        <source>The study has %n part(s).</source>
        <translation>
            <numerusform>Η μελέτη έχει %n μέρος.</numerusform>
            <numerusform>Η μελέτη έχει %n μέρη.</numerusform>
        </translation>
    </message>
    <message>
        <source>What you do differs from part to part:</source>
        <translation>Αυτό που κάνετε διαφέρει από μέρος σε μέρος:</translation>
    </message>
    <message>
        <source>Touch every object before you answer.</source>
        <translation>Αγγίξτε κάθε αντικείμενο πριν απαντήσετε.</translation>
    </message>
    <message>
        <source>How many trials there are depends on your answers.</source>
        <translation>Το πλήθος των δοκιμών εξαρτάται από τις απαντήσεις σας.</translation>
    </message>
    <message numerus="yes">
        <source>Each part has %n trial(s).</source>
        <translation>
            <numerusform>Κάθε μέρος έχει %n δοκιμή.</numerusform>
            <numerusform>Κάθε μέρος έχει %n δοκιμές.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Each part has at most %n trial(s).</source>
        <translation>
            <numerusform>Κάθε μέρος έχει το πολύ %n δοκιμή.</numerusform>
            <numerusform>Κάθε μέρος έχει το πολύ %n δοκιμές.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There are %n trial(s).</source>
        <translation>
            <numerusform>Υπάρχει %n δοκιμή.</numerusform>
            <numerusform>Υπάρχουν %n δοκιμές.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There are at most %n trial(s).</source>
        <translation>
            <numerusform>Υπάρχει το πολύ %n δοκιμή.</numerusform>
            <numerusform>Υπάρχουν το πολύ %n δοκιμές.</numerusform>
        </translation>
    </message>
    <message>
        <source>You may take as long as you like over each trial.</source>
        <translation>Για κάθε δοκιμή έχετε όσο χρόνο θέλετε.</translation>
    </message>
    <message>
        <source>You have %1 seconds for each trial.</source>
        <translation>Για κάθε δοκιμή έχετε %1 δευτερόλεπτα.</translation>
    </message>
    <message>
        <source>You have %1 seconds to explore in each trial.</source>
        <translation>Σε κάθε δοκιμή έχετε %1 δευτερόλεπτα για εξερεύνηση.</translation>
    </message>
    <message>
        <source>Then the objects go away, and you have another %1 seconds to answer.</source>
        <translation>Έπειτα τα αντικείμενα εξαφανίζονται και έχετε άλλα %1 δευτερόλεπτα για να απαντήσετε.</translation>
    </message>
    <message>
        <source>Then the objects go away, and you may take as long as you like to answer.</source>
        <translation>Έπειτα τα αντικείμενα εξαφανίζονται και έχετε όσο χρόνο θέλετε για να απαντήσετε.</translation>
    </message>
    <message>
        <source>After each trial you are told whether your answer was right.</source>
        <translation>Μετά από κάθε δοκιμή μαθαίνετε αν η απάντησή σας ήταν σωστή.</translation>
    </message>
    <message>
        <source>You are not told whether your answers are right.</source>
        <translation>Δεν μαθαίνετε αν οι απαντήσεις σας είναι σωστές.</translation>
    </message>
    <message>
        <source>After each trial you are told how far your mark is from the highest point.</source>
        <translation>Μετά από κάθε δοκιμή μαθαίνετε πόσο απέχει το σημείο σας από το ψηλότερο.</translation>
    </message>
    <message>
        <source>You are not told how far your marks are from the highest point.</source>
        <translation>Δεν μαθαίνετε πόσο απέχουν τα σημεία σας από το ψηλότερο.</translation>
    </message>
    <message>
        <source>No breaks are planned; you may pause whenever you want.</source>
        <translation>Δεν προβλέπονται διαλείμματα· μπορείτε να σταματάτε όποτε θέλετε.</translation>
    </message>
    <message numerus="yes">
        <source>After every %n trial(s) there is a break</source>
        <translation>
            <numerusform>Μετά από κάθε %n δοκιμή υπάρχει διάλειμμα</numerusform>
            <numerusform>Μετά από κάθε %n δοκιμές υπάρχει διάλειμμα</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of at least %2 seconds; you may also pause whenever you want.</source>
        <translation>%1 τουλάχιστον %2 δευτερολέπτων· μπορείτε επίσης να σταματάτε όποτε θέλετε.</translation>
    </message>
    <message>
        <source>%1; you may also pause whenever you want.</source>
        <translation>%1· μπορείτε επίσης να σταματάτε όποτε θέλετε.</translation>
    </message>
    <message numerus="yes">
        <source>Before the trials you answer %n question(s).</source>
        <translation>
            <numerusform>Πριν από τις δοκιμές απαντάτε σε %n ερώτηση.</numerusform>
            <numerusform>Πριν από τις δοκιμές απαντάτε σε %n ερωτήσεις.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>After the trials you answer %n question(s).</source>
        <translation>
            <numerusform>Μετά τις δοκιμές απαντάτε σε %n ερώτηση.</numerusform>
            <numerusform>Μετά τις δοκιμές απαντάτε σε %n ερωτήσεις.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Each part begins with %n practice trial(s), which do not count.</source>
        <translation>
            <numerusform>Κάθε μέρος αρχίζει με %n δοκιμή εξάσκησης, που δεν μετρά.</numerusform>
            <numerusform>Κάθε μέρος αρχίζει με %n δοκιμές εξάσκησης, που δεν μετρούν.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>After each part you answer %n question(s) about it.</source>
        <translation>
            <numerusform>Μετά από κάθε μέρος απαντάτε σε %n ερώτηση για αυτό.</numerusform>
            <numerusform>Μετά από κάθε μέρος απαντάτε σε %n ερωτήσεις για αυτό.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>After the trials you answer %n question(s) about them.</source>
        <translation>
            <numerusform>Μετά τις δοκιμές απαντάτε σε %n ερώτηση για αυτές.</numerusform>
            <numerusform>Μετά τις δοκιμές απαντάτε σε %n ερωτήσεις για αυτές.</numerusform>
        </translation>
    </message>
    <message>
        <source>Touch every object before you answer; a graze is not enough, and the screen says when more force is needed.</source>
        <translation>Αγγίξτε κάθε αντικείμενο πριν απαντήσετε· ένα ελαφρύ άγγιγμα δεν αρκεί, και η οθόνη δείχνει πότε χρειάζεται περισσότερη δύναμη.</translation>
    </message>
    <message>
        <source>In each trial you search for the highest point of an object with the tip and mark it.</source>
        <translation>Σε κάθε δοκιμή αναζητάτε με την άκρη το ψηλότερο σημείο ενός αντικειμένου και το σημειώνετε.</translation>
    </message>
    <message>
        <source>In each trial you explore three objects and put them in order; you may mark those that seem the same as equal.</source>
        <translation>Σε κάθε δοκιμή εξερευνάτε τρία αντικείμενα και τα βάζετε σε σειρά· όσα σας μοιάζουν ίδια μπορείτε να τα δηλώσετε ως ίσα.</translation>
    </message>
    <message>
        <source>In each trial you change one object until it seems like the other, and confirm.</source>
        <translation>Σε κάθε δοκιμή μεταβάλλετε ένα αντικείμενο ώσπου να σας μοιάζει με το άλλο και επιβεβαιώνετε.</translation>
    </message>
    <message>
        <source>In each trial you explore one object and compare it with the reference, which the experimenter shows you before the trials; you answer yes or no.</source>
        <translation>Σε κάθε δοκιμή εξερευνάτε ένα αντικείμενο και το συγκρίνετε με την αναφορά, που σας δείχνει ο πειραματιστής πριν από τις δοκιμές· απαντάτε με ναι ή όχι.</translation>
    </message>
    <message>
        <source>Where you search for the highest point, the trial ends after these %1 seconds.</source>
        <translation>Όπου αναζητάτε το ψηλότερο σημείο, η δοκιμή τελειώνει μετά από αυτά τα %1 δευτερόλεπτα.</translation>
    </message>
    <message>
        <source>Only in practice are you told whether your answer was right.</source>
        <translation>Μόνο στην εξάσκηση μαθαίνετε αν η απάντησή σας ήταν σωστή.</translation>
    </message>
    <message>
        <source>Only in practice are you told how far your mark is from the highest point.</source>
        <translation>Μόνο στην εξάσκηση μαθαίνετε πόσο απέχει το σημείο σας από το ψηλότερο.</translation>
    </message>
    <message numerus="yes">
        <source>First come %n practice trial(s), which do not count.</source>
        <translation>
            <numerusform>Στην αρχή υπάρχει %n δοκιμή εξάσκησης, που δεν μετρά.</numerusform>
            <numerusform>Στην αρχή υπάρχουν %n δοκιμές εξάσκησης, που δεν μετρούν.</numerusform>
        </translation>
    </message>
    <message>
        <source>Pull gently and move calmly: a trial in which you pull with more than %1, or move faster than %2 per second on average, is repeated.</source>
        <translation>Τραβάτε απαλά και κινείστε ήρεμα: μια δοκιμή στην οποία τραβάτε με πάνω από %1 ή κινείστε κατά μέσο όρο ταχύτερα από %2 ανά δευτερόλεπτο επαναλαμβάνεται.</translation>
    </message>
    <message>
        <source>Press gently and move calmly: a trial in which you press with more than %1, or move faster than %2 per second on average, is repeated.</source>
        <translation>Πιέζετε απαλά και κινείστε ήρεμα: μια δοκιμή στην οποία πιέζετε με πάνω από %1 ή κινείστε κατά μέσο όρο ταχύτερα από %2 ανά δευτερόλεπτο επαναλαμβάνεται.</translation>
    </message>
    <message>
        <source>Before that you have a free minute to try the controls, which does not count either.</source>
        <translation>Πριν από αυτό έχετε ένα ελεύθερο λεπτό για να δοκιμάσετε τον χειρισμό, που επίσης δεν μετρά.</translation>
    </message>
    <message>
        <source>Before the trials you have a free minute to try the controls, which does not count.</source>
        <translation>Πριν από τις δοκιμές έχετε ένα ελεύθερο λεπτό για να δοκιμάσετε τον χειρισμό, που δεν μετρά.</translation>
    </message>
    <message>
        <source>Move calmly and put objects down gently: a trial in which you press one onto the table with more than %1, or move faster than %2 per second on average, is repeated.</source>
        <translation>Κινείστε ήρεμα και ακουμπάτε τα αντικείμενα απαλά: μια δοκιμή στην οποία πιέζετε κάποιο στο τραπέζι με πάνω από %1 ή κινείστε κατά μέσο όρο ταχύτερα από %2 ανά δευτερόλεπτο επαναλαμβάνεται.</translation>
    </message>
    <message>
        <source>The device pushes back against your hand. You can let go at any time, and the Esc key switches its force off at once.</source>
        <translation>Η συσκευή πιέζει το χέρι σας. Μπορείτε να την αφήσετε οποτεδήποτε, και το πλήκτρο Esc διακόπτει αμέσως τη δύναμή της.</translation>
    </message>
    <message>
        <source>The device of this station renders no force: you see how objects respond, and nothing pushes against your hand.</source>
        <translation>Η συσκευή αυτού του σταθμού δεν αποδίδει δύναμη: βλέπετε πώς αντιδρούν τα αντικείμενα, και τίποτα δεν πιέζει το χέρι σας.</translation>
    </message>
    <message>
        <source>Lift every object before you answer.</source>
        <translation>Σηκώστε κάθε αντικείμενο πριν απαντήσετε.</translation>
    </message>
    <message>
        <source>Pull every object before you answer; the screen says when more force is needed.</source>
        <translation>Τραβήξτε κάθε αντικείμενο πριν απαντήσετε· η οθόνη δείχνει πότε χρειάζεται περισσότερη δύναμη.</translation>
    </message>
    <message>
        <source>Pull every object before you answer.</source>
        <translation>Τραβήξτε κάθε αντικείμενο πριν απαντήσετε.</translation>
    </message>
    <message>
        <source>Explore every object before you answer; the screen says when more force is needed.</source>
        <translation>Εξερευνήστε κάθε αντικείμενο πριν απαντήσετε· η οθόνη δείχνει πότε χρειάζεται περισσότερη δύναμη.</translation>
    </message>
    <message>
        <source>Explore every object before you answer.</source>
        <translation>Εξερευνήστε κάθε αντικείμενο πριν απαντήσετε.</translation>
    </message>
    <message>
        <source>The device pushes back against your hand, with at most %1. You can let go at any time, and the Esc key switches its force off at once.</source>
        <translation>Η συσκευή πιέζει το χέρι σας, με το πολύ %1. Μπορείτε να την αφήσετε οποτεδήποτε, και το πλήκτρο Esc διακόπτει αμέσως τη δύναμή της.</translation>
    </message>
</context>
<context>
    <name>PeopleNames</name>
    <message>
        <source>Scripted hand</source>
        <translation>Προγραμματισμένο χέρι</translation>
    </message>
</context>
<context>
    <name>PlanWords</name>
    <message>
        <source>All of %1 simulated runs gave a usable value.</source>
        <translation>Και οι %1 προσομοιωμένες εκτελέσεις έδωσαν αξιοποιήσιμη τιμή.</translation>
    </message>
    <message>
        <source>With about %1 trials or more, fewer than 1 run in 20 gives no usable value.</source>
        <translation>Με περίπου %1 δοκιμές ή περισσότερες, λιγότερες από 1 στις 20 εκτελέσεις μένουν χωρίς αξιοποιήσιμη τιμή.</translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 simulated run(s) gave no usable value; such runs are left out of group values.</source>
        <translation>
            <numerusform>%n από τις %1 προσομοιωμένες εκτελέσεις δεν έδωσε αξιοποιήσιμη τιμή· τέτοιες εκτελέσεις εξαιρούνται από τις τιμές της ομάδας.</numerusform>
            <numerusform>%n από τις %1 προσομοιωμένες εκτελέσεις δεν έδωσαν αξιοποιήσιμη τιμή· τέτοιες εκτελέσεις εξαιρούνται από τις τιμές της ομάδας.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PlatformCheck</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Noise, hysteresis and creep of the force sensors</source>
        <translation>Θόρυβος, υστέρηση και ερπυσμός των αισθητήρων δύναμης</translation>
    </message>
    <message>
        <source>Resolution of the converter</source>
        <translation>Ανάλυση του μετατροπέα</translation>
    </message>
    <message>
        <source>Delay of the force sensors</source>
        <translation>Καθυστέρηση των αισθητήρων δύναμης</translation>
    </message>
    <message>
        <source>Friction of the drives</source>
        <translation>Τριβή των κινητήρων</translation>
    </message>
    <message>
        <source>Backlash of the gears</source>
        <translation>Τζόγος των γραναζιών</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 bit</translation>
    </message>
    <message>
        <source>%1 times as coarse</source>
        <translation>%1 φορές πιο αδρή</translation>
    </message>
    <message>
        <source>none</source>
        <translation>κανένα</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>This is the simulated platform, with hardware as imperfect as real parts are: force noise of %1 mN and %2 bits of the converter, hysteresis of %3 %, a delay of %4 ms from sensor to controller, gear friction of %5 N per drive, backlash of %6 µm, an orientation sensor with %7° bias and %8° noise.</source>
        <translation>Αυτή είναι η προσομοιωμένη πλατφόρμα, τόσο ατελής όσο τα πραγματικά εξαρτήματα: θόρυβος δύναμης %1 mN και %2 bit του μετατροπέα, υστέρηση %3 %, καθυστέρηση %4 ms από αισθητήρα σε ελεγκτή, τριβή γραναζιών %5 N ανά κινητήρα, τζόγος %6 µm, αισθητήρας προσανατολισμού με απόκλιση %7° και θόρυβο %8°.</translation>
    </message>
    <message>
        <source>Friction, identified by moving the drives: %1 N, plus %2 N·s/m with speed.</source>
        <translation>Τριβή, όπως προσδιορίστηκε κινώντας τους κινητήρες: %1 N, συν %2 N·s/m με την ταχύτητα.</translation>
    </message>
    <message>
        <source>A step of force is felt after %1 ms. With the damping of drives and fingertip alone, a wall is stable up to %2 N/mm.</source>
        <translation>Μια βηματική μεταβολή δύναμης γίνεται αισθητή μετά από %1 ms. Μόνο με την απόσβεση κινητήρων και δακτύλου, ένας τοίχος είναι ευσταθής έως %2 N/mm.</translation>
    </message>
    <message>
        <source>Noise and offset of the orientation sensor</source>
        <translation>Θόρυβος και απόκλιση του αισθητήρα προσανατολισμού</translation>
    </message>
    <message>
        <source>A simulation: the simulated platform stays within its bounds on %1 of %2 simulated fingers. At worst, the force on the fingertip is off by %3 (root mean square), the orientation by %4, a step overshoots by %5 % of the force, and the fingertip gets at most %6 (%7). A real platform has to be measured separately.</source>
        <translation>Προσομοίωση: η προσομοιωμένη πλατφόρμα μένει εντός των ορίων της σε %1 από %2 προσομοιωμένα δάκτυλα. Στη χειρότερη περίπτωση η δύναμη στο δάκτυλο αποκλίνει κατά %3 (τετραγωνικός μέσος), ο προσανατολισμός κατά %4, ένα βήμα έχει υπερύψωση %5 % της δύναμης, και το δάκτυλο δέχεται το πολύ %6 (%7). Μια πραγματική πλατφόρμα πρέπει να μετρηθεί χωριστά.</translation>
    </message>
    <message>
        <source>bounds: %1, %2, %3 %, %4</source>
        <translation>όρια: %1, %2, %3 %, %4</translation>
    </message>
    <message>
        <source>Half as stiff</source>
        <translation>Μισή δυσκαμψία</translation>
    </message>
    <message>
        <source>Twice as stiff</source>
        <translation>Διπλάσια δυσκαμψία</translation>
    </message>
    <message>
        <source>Thick</source>
        <translation>Παχύ</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Λεπτό</translation>
    </message>
    <message>
        <source>Its force relaxes by 40 %</source>
        <translation>Η δύναμή του χαλαρώνει κατά 40 %</translation>
    </message>
    <message>
        <source>Half as stiff, thick, relaxing</source>
        <translation>Μισή δυσκαμψία, παχύ, χαλαρώνει</translation>
    </message>
    <message>
        <source>Twice as stiff, thin, relaxing</source>
        <translation>Διπλάσια δυσκαμψία, λεπτό, χαλαρώνει</translation>
    </message>
    <message>
        <source>The assumed finger</source>
        <translation>Παραδοχή για το δάκτυλο</translation>
    </message>
    <message>
        <source>On other fingers: the true force on the fingertip</source>
        <translation>Σε άλλα δάκτυλα: η πραγματική δύναμη στο δάκτυλο</translation>
    </message>
    <message>
        <source>Simulated finger</source>
        <translation>Προσομοιωμένο δάκτυλο</translation>
    </message>
    <message>
        <source>Gain, phase</source>
        <translation>Κέρδος, φάση</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Υπερύψωση</translation>
    </message>
    <message>
        <source>Max. at 1 N</source>
        <translation>Μέγ. στο 1 N</translation>
    </message>
    <message>
        <source>Max. at 4 N</source>
        <translation>Μέγ. στα 4 N</translation>
    </message>
    <message>
        <source>Within its bounds</source>
        <translation>Εντός ορίων</translation>
    </message>
    <message>
        <source>%1, %2°</source>
        <translation>%1, %2°</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Compared with the published figures</source>
        <translation>Σύγκριση με τις δημοσιευμένες τιμές</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Μέγεθος</translation>
    </message>
    <message>
        <source>By its own sensors</source>
        <translation>Με τους δικούς της αισθητήρες</translation>
    </message>
    <message>
        <source>True value</source>
        <translation>Πραγματική τιμή</translation>
    </message>
    <message>
        <source>Published (P3)</source>
        <translation>Δημοσιευμένο (P3)</translation>
    </message>
    <message>
        <source>Force, cycle %1: root mean square error</source>
        <translation>Δύναμη, κύκλος %1: τετραγωνικός μέσος του σφάλματος</translation>
    </message>
    <message>
        <source>Force, mean of the cycles</source>
        <translation>Δύναμη, μέσος όρος των κύκλων</translation>
    </message>
    <message>
        <source>Orientation, mean error of %1 poses</source>
        <translation>Προσανατολισμός, μέσο σφάλμα %1 στάσεων</translation>
    </message>
    <message>
        <source>Orientation, standard deviation</source>
        <translation>Προσανατολισμός, τυπική απόκλιση</translation>
    </message>
    <message>
        <source>Force error</source>
        <translation>Σφάλμα δύναμης</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ναι</translation>
    </message>
    <message>
        <source>no</source>
        <translation>όχι</translation>
    </message>
    <message>
        <source>When one part gets worse</source>
        <translation>Όταν ένα εξάρτημα χειροτερεύει</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Τι</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Πόσο</translation>
    </message>
    <message>
        <source>Orientation error</source>
        <translation>Σφάλμα προσανατολισμού</translation>
    </message>
</context>
<context>
    <name>PlatformPlots</name>
    <message>
        <source>Force over three cycles</source>
        <translation>Δύναμη σε τρεις κύκλους</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Χρόνος (s)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Δύναμη (N)</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>μετρημένη</translation>
    </message>
    <message>
        <source>on the fingertip</source>
        <translation>στο δάκτυλο</translation>
    </message>
    <message>
        <source>target</source>
        <translation>ζητούμενη</translation>
    </message>
    <message>
        <source>Orientations, measured against target</source>
        <translation>Προσανατολισμοί, μετρημένοι προς ζητούμενους</translation>
    </message>
    <message>
        <source>Target (°)</source>
        <translation>Ζητούμενη (°)</translation>
    </message>
    <message>
        <source>Measured (°)</source>
        <translation>Μετρημένη (°)</translation>
    </message>
    <message>
        <source>ideal</source>
        <translation>ιδανική τιμή</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>πρόνευση</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>κύλιση</translation>
    </message>
    <message>
        <source>Distribution of the orientation errors</source>
        <translation>Κατανομή των σφαλμάτων προσανατολισμού</translation>
    </message>
    <message>
        <source>Error (°)</source>
        <translation>Σφάλμα (°)</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Στάσεις</translation>
    </message>
    <message>
        <source>poses</source>
        <translation>στάσεις</translation>
    </message>
</context>
<context>
    <name>PlaybackMarks</name>
    <message>
        <source>Force on hold: the tool moved too fast</source>
        <translation>Αναστολή δύναμης: το εργαλείο κινήθηκε πολύ γρήγορα</translation>
    </message>
    <message>
        <source>The device sent an invalid sample</source>
        <translation>Ένα δείγμα της συσκευής δεν ήταν έγκυρο</translation>
    </message>
    <message>
        <source>Fault: the device sent too many invalid samples</source>
        <translation>Βλάβη: πάρα πολλά δείγματα της συσκευής δεν ήταν έγκυρα</translation>
    </message>
    <message>
        <source>Force on hold: samples from the device came late</source>
        <translation>Αναστολή δύναμης: τα δείγματα της συσκευής καθυστέρησαν</translation>
    </message>
    <message>
        <source>Fault: the device stopped sending data</source>
        <translation>Βλάβη: η συσκευή σταμάτησε να στέλνει δεδομένα</translation>
    </message>
    <message>
        <source>Force on hold: the window did not respond</source>
        <translation>Αναστολή δύναμης: το παράθυρο δεν ανταποκρίθηκε</translation>
    </message>
    <message>
        <source>Force damped to keep it stable</source>
        <translation>Απόσβεση δύναμης για σταθερότητα</translation>
    </message>
    <message>
        <source>Fault: reported by the device</source>
        <translation>Βλάβη: την ανέφερε η συσκευή</translation>
    </message>
    <message>
        <source>The force supervisor stepped in</source>
        <translation>Επενέβη ο επόπτης δύναμης</translation>
    </message>
    <message>
        <source>Trial %1 begins</source>
        <translation>Αρχίζει η δοκιμή %1</translation>
    </message>
    <message>
        <source>Marked the highest point</source>
        <translation>Σημειώθηκε το ψηλότερο σημείο</translation>
    </message>
    <message>
        <source>Time was up without a mark</source>
        <translation>Έληξε ο χρόνος χωρίς σημείο</translation>
    </message>
    <message>
        <source>The trace ended without a mark</source>
        <translation>Η καταγραφή τελείωσε χωρίς σημείο</translation>
    </message>
    <message>
        <source>In contact for %1</source>
        <translation>Σε επαφή για %1</translation>
    </message>
    <message>
        <source>Paused for %1</source>
        <translation>Σε παύση για %1</translation>
    </message>
    <message>
        <source>Force re-armed</source>
        <translation>Η δύναμη ενεργοποιήθηκε ξανά</translation>
    </message>
    <message>
        <source>The person ended the session</source>
        <translation>Το άτομο τερμάτισε τη συνεδρία</translation>
    </message>
    <message>
        <source>The insertion begins</source>
        <translation>Αρχίζει η εισαγωγή</translation>
    </message>
    <message>
        <source>The inspection begins</source>
        <translation>Αρχίζει η επισκόπηση</translation>
    </message>
    <message>
        <source>The withdrawal begins</source>
        <translation>Αρχίζει η απόσυρση</translation>
    </message>
    <message>
        <source>Step: take hold</source>
        <translation>Βήμα: πιάσιμο</translation>
    </message>
    <message>
        <source>Step: stretch</source>
        <translation>Βήμα: τέντωμα</translation>
    </message>
    <message>
        <source>Step: hold still</source>
        <translation>Βήμα: σταθερό κράτημα</translation>
    </message>
    <message>
        <source>Step: hand over</source>
        <translation>Βήμα: παράδοση στο άλλο χέρι</translation>
    </message>
    <message>
        <source>Step: lift</source>
        <translation>Βήμα: ανύψωση</translation>
    </message>
    <message>
        <source>Step: carry to the target</source>
        <translation>Βήμα: μεταφορά στον στόχο</translation>
    </message>
    <message>
        <source>Step: set down</source>
        <translation>Βήμα: απόθεση</translation>
    </message>
    <message>
        <source>Step: hold the tissue back</source>
        <translation>Βήμα: συγκράτηση του ιστού</translation>
    </message>
    <message>
        <source>The next stage begins</source>
        <translation>Αρχίζει το επόμενο στάδιο</translation>
    </message>
    <message>
        <source>Landmarks seen: %1</source>
        <translation>Οδηγά σημεία που φάνηκαν: %1</translation>
    </message>
    <message>
        <source>A landmark was seen</source>
        <translation>Φάνηκε ένα οδηγό σημείο</translation>
    </message>
    <message>
        <source>Moved back by %1</source>
        <translation>Οπισθοχώρηση κατά %1</translation>
    </message>
    <message>
        <source>Off-centre for %1, up to %2</source>
        <translation>Απόκλιση από τον άξονα για %1, έως %2</translation>
    </message>
    <message>
        <source>Torque over its limit for %1, up to %2</source>
        <translation>Ροπή πάνω από το όριό της για %1, έως %2</translation>
    </message>
    <message>
        <source>Took hold</source>
        <translation>Πιάσιμο</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Απελευθέρωση</translation>
    </message>
    <message>
        <source>Slipped out or dropped</source>
        <translation>Γλίστρημα ή πτώση</translation>
    </message>
    <message>
        <source>Critical error: %1</source>
        <translation>Κρίσιμο σφάλμα: %1</translation>
    </message>
    <message>
        <source>The tissue gave way at %1</source>
        <translation>Ο ιστός υποχώρησε στα %1</translation>
    </message>
    <message>
        <source>Finding %1 marked</source>
        <translation>Σημειώθηκε το εύρημα %1</translation>
    </message>
    <message>
        <source>Finding %1 taken back</source>
        <translation>Αποσύρθηκε το εύρημα %1</translation>
    </message>
    <message>
        <source>The trial was completed</source>
        <translation>Η δοκιμή ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>The trial could no longer be completed</source>
        <translation>Η δοκιμή δεν μπορούσε πια να ολοκληρωθεί</translation>
    </message>
    <message>
        <source>The tissue was damaged</source>
        <translation>Ο ιστός τραυματίστηκε</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Τέλος</translation>
    </message>
    <message>
        <source>The procedure was completed</source>
        <translation>Η διαδικασία ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>Time was up before the end of the procedure</source>
        <translation>Ο χρόνος έληξε πριν από το τέλος της διαδικασίας</translation>
    </message>
    <message>
        <source>The procedure could no longer be completed</source>
        <translation>Η διαδικασία δεν μπορούσε πια να ολοκληρωθεί</translation>
    </message>
    <message>
        <source>The tube was held as asked</source>
        <translation>Ο σωλήνας κρατήθηκε όπως ζητήθηκε</translation>
    </message>
    <message>
        <source>Time was up before the tube was held as asked</source>
        <translation>Ο χρόνος έληξε πριν κρατηθεί ο σωλήνας όπως ζητήθηκε</translation>
    </message>
    <message>
        <source>The tube tore: the trial could no longer be completed</source>
        <translation>Ο σωλήνας σχίστηκε: η δοκιμή δεν μπορούσε πια να ολοκληρωθεί</translation>
    </message>
    <message>
        <source>The tube was stretched too far</source>
        <translation>Ο σωλήνας τεντώθηκε υπερβολικά</translation>
    </message>
    <message>
        <source>An object was set down in the target</source>
        <translation>Ένα αντικείμενο αποτέθηκε στον στόχο</translation>
    </message>
    <message>
        <source>Time was up before an object was set down in the target</source>
        <translation>Ο χρόνος έληξε πριν αποτεθεί αντικείμενο στον στόχο</translation>
    </message>
    <message>
        <source>The object was squeezed too hard</source>
        <translation>Το αντικείμενο σφίχτηκε υπερβολικά</translation>
    </message>
    <message>
        <source>The search was reported as done</source>
        <translation>Η αναζήτηση δηλώθηκε ως ολοκληρωμένη</translation>
    </message>
    <message>
        <source>Time was up before the search was reported as done</source>
        <translation>Ο χρόνος έληξε πριν δηλωθεί η αναζήτηση ως ολοκληρωμένη</translation>
    </message>
    <message>
        <source>The search could no longer be completed</source>
        <translation>Η αναζήτηση δεν μπορούσε πια να ολοκληρωθεί</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>Δόθηκε απάντηση</translation>
    </message>
    <message>
        <source>The comparison was completed</source>
        <translation>Η σύγκριση ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>Time was up without an answer</source>
        <translation>Ο χρόνος έληξε χωρίς απάντηση</translation>
    </message>
    <message>
        <source>The comparison could no longer be completed</source>
        <translation>Η σύγκριση δεν μπορούσε πια να ολοκληρωθεί</translation>
    </message>
    <message>
        <source>The object was damaged</source>
        <translation>Το αντικείμενο υπέστη ζημιά</translation>
    </message>
    <message>
        <source>The person stopped the force for %1</source>
        <translation>Το άτομο διέκοψε τη δύναμη για %1</translation>
    </message>
    <message>
        <source>The person stopped the force</source>
        <translation>Το άτομο διέκοψε τη δύναμη</translation>
    </message>
    <message>
        <source>For %1, less force was felt than the tissue exerted (up to %2)</source>
        <translation>Για %1 έγινε αισθητή μικρότερη δύναμη από αυτήν του ιστού (έως %2)</translation>
    </message>
    <message>
        <source>Miss: the wrong place was marked</source>
        <translation>Αστοχία: σημειώθηκε λάθος θέση</translation>
    </message>
    <message>
        <source>Finding %1 marked where there was no lump</source>
        <translation>Το εύρημα %1 σημειώθηκε όπου δεν υπήρχε όζος</translation>
    </message>
    <message>
        <source>A lump was missed</source>
        <translation>Ένας όζος δεν βρέθηκε</translation>
    </message>
    <message>
        <source>The tissue gave way at a torque of %1</source>
        <translation>Ο ιστός υποχώρησε σε ροπή %1</translation>
    </message>
    <message>
        <source>The object came off the tool at %1</source>
        <translation>Το αντικείμενο ξέφυγε από το εργαλείο στα %1</translation>
    </message>
    <message>
        <source>Trauma event: pressed sideways on the wall for %1, up to %2</source>
        <translation>Συμβάν τραυματισμού: πλάγια πίεση στο τοίχωμα για %1, έως %2</translation>
    </message>
    <message>
        <source>Over the force limit for %1, up to %2</source>
        <translation>Πάνω από το όριο δύναμης για %1, έως %2</translation>
    </message>
</context>
<context>
    <name>Procedures</name>
    <message>
        <source>Trials per level</source>
        <translation>Δοκιμές ανά επίπεδο</translation>
    </message>
    <message>
        <source>In random order</source>
        <translation>Με τυχαία σειρά</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Επίπεδα</translation>
    </message>
    <message>
        <source>What is presented. Levels must lie within the table of differences.</source>
        <translation>Τι παρουσιάζεται. Τα επίπεδα πρέπει να βρίσκονται στον πίνακα διαφορών.</translation>
    </message>
    <message>
        <source>Constant stimuli</source>
        <translation>Σταθερά ερεθίσματα</translation>
    </message>
    <message>
        <source>Presents every difference equally often, in random order. Measures the whole curve, but needs many trials.</source>
        <translation>Παρουσιάζει κάθε διαφορά εξίσου συχνά, με τυχαία σειρά. Μετρά όλη την καμπύλη, αλλά χρειάζεται πολλές δοκιμές.</translation>
    </message>
    <message>
        <source>Presentations per level</source>
        <translation>Παρουσιάσεις ανά επίπεδο</translation>
    </message>
    <message>
        <source>Right answers to go on</source>
        <translation>Σωστές απαντήσεις για συνέχεια</translation>
    </message>
    <message>
        <source>With fewer right answers at a level the run ends there.</source>
        <translation>Με λιγότερες σωστές απαντήσεις σε ένα επίπεδο η εκτέλεση τελειώνει εκεί.</translation>
    </message>
    <message>
        <source>What is presented, from the largest to the smallest difference.</source>
        <translation>Τι παρουσιάζεται, από τη μεγαλύτερη προς τη μικρότερη διαφορά.</translation>
    </message>
    <message>
        <source>Descending ranking (legacy)</source>
        <translation>Φθίνουσα κατάταξη (παλαιά)</translation>
    </message>
    <message>
        <source>The difference shrinks until an answer is wrong. The resulting JND is 1.5 to 3 times too large; for replications only.</source>
        <translation>Η διαφορά μικραίνει ώσπου μια απάντηση να είναι λάθος. Η JND που προκύπτει είναι 1,5 έως 3 φορές μεγαλύτερη από την πραγματική· μόνο για επαναλήψεις παλαιότερων εργασιών.</translation>
    </message>
    <message>
        <source>Maximum trials</source>
        <translation>Μέγιστος αριθμός δοκιμών</translation>
    </message>
    <message>
        <source>Reversals until stop</source>
        <translation>Αναστροφές ως το τέλος</translation>
    </message>
    <message>
        <source>Minimum trials</source>
        <translation>Ελάχιστος αριθμός δοκιμών</translation>
    </message>
    <message>
        <source>The run ends once the threshold is known within this difference (one standard deviation).</source>
        <translation>Η εκτέλεση τελειώνει όταν το κατώφλι είναι γνωστό με ακρίβεια αυτής της διαφοράς (μία τυπική απόκλιση).</translation>
    </message>
    <message>
        <source>The run ends once the threshold is known within this factor (one standard deviation). Usually × 1.15.</source>
        <translation>Η εκτέλεση τελειώνει όταν το κατώφλι είναι γνωστό με αυτόν τον συντελεστή (μία τυπική απόκλιση). Συνήθως × 1,15.</translation>
    </message>
    <message>
        <source>never</source>
        <translation>ποτέ</translation>
    </message>
    <message>
        <source>First difference</source>
        <translation>Πρώτη διαφορά</translation>
    </message>
    <message>
        <source>Where the run begins: large enough to be felt by everybody.</source>
        <translation>Από πού αρχίζει η εκτέλεση: αρκετά μεγάλη ώστε να την αισθάνονται όλοι.</translation>
    </message>
    <message>
        <source>First step</source>
        <translation>Πρώτο βήμα</translation>
    </message>
    <message>
        <source>How far the difference changes at first.</source>
        <translation>Πόσο αλλάζει αρχικά η διαφορά.</translation>
    </message>
    <message>
        <source>Smallest step</source>
        <translation>Μικρότερο βήμα</translation>
    </message>
    <message>
        <source>The run ends when a step would be as small as this.</source>
        <translation>Η εκτέλεση τελειώνει όταν το επόμενο βήμα θα ήταν τόσο μικρό.</translation>
    </message>
    <message>
        <source>Largest step</source>
        <translation>Μεγαλύτερο βήμα</translation>
    </message>
    <message>
        <source>Steps never grow beyond this.</source>
        <translation>Τα βήματα δεν γίνονται ποτέ μεγαλύτερα.</translation>
    </message>
    <message>
        <source>PEST</source>
        <translation>PEST</translation>
    </message>
    <message>
        <source>A sequential test halves and doubles the steps. For replications only.</source>
        <translation>Ένας διαδοχικός έλεγχος υποδιπλασιάζει και διπλασιάζει τα βήματα. Μόνο για επαναλήψεις παλαιότερων εργασιών.</translation>
    </message>
    <message>
        <source>Expected threshold</source>
        <translation>Αναμενόμενο κατώφλι</translation>
    </message>
    <message>
        <source>Where the threshold is expected before the first answer.</source>
        <translation>Πού αναμένεται το κατώφλι πριν από την πρώτη απάντηση.</translation>
    </message>
    <message>
        <source>How far off the expectation may be (one standard deviation).</source>
        <translation>Πόσο μπορεί να αστοχεί η πρόβλεψη (μία τυπική απόκλιση).</translation>
    </message>
    <message>
        <source>How far off the expectation may be (one standard deviation). Usually × 3.</source>
        <translation>Πόσο μπορεί να αστοχεί η πρόβλεψη (μία τυπική απόκλιση). Συνήθως × 3.</translation>
    </message>
    <message>
        <source>Slope β</source>
        <translation>Κλίση β</translation>
    </message>
    <message>
        <source>Lapses</source>
        <translation>Αβλεψίες</translation>
    </message>
    <message>
        <source>Right by guessing</source>
        <translation>Σωστές από τύχη</translation>
    </message>
    <message>
        <source>Quantile</source>
        <translation>Ποσοστημόριο</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Μέση τιμή</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Επικρατούσα τιμή</translation>
    </message>
    <message>
        <source>Place trials at</source>
        <translation>Τοποθέτηση δοκιμών</translation>
    </message>
    <message>
        <source>QUEST</source>
        <translation>QUEST</translation>
    </message>
    <message>
        <source>Bayesian; places each trial where the threshold probably is.</source>
        <translation>Μπεϋζιανή· τοποθετεί κάθε δοκιμή εκεί όπου πιθανώς βρίσκεται το κατώφλι.</translation>
    </message>
    <message>
        <source>Weibull</source>
        <translation>Weibull</translation>
    </message>
    <message>
        <source>Normal (probit)</source>
        <translation>Κανονική (probit)</translation>
    </message>
    <message>
        <source>Normal, lapses on both sides</source>
        <translation>Κανονική, αβλεψίες και στις δύο πλευρές</translation>
    </message>
    <message>
        <source>Logistic (logit)</source>
        <translation>Λογιστική (logit)</translation>
    </message>
    <message>
        <source>Gumbel</source>
        <translation>Gumbel</translation>
    </message>
    <message>
        <source>Gumbel, mirrored</source>
        <translation>Gumbel, κατοπτρική</translation>
    </message>
    <message>
        <source>Hyperbolic secant</source>
        <translation>Υπερβολική τέμνουσα</translation>
    </message>
    <message>
        <source>Psychometric function</source>
        <translation>Ψυχομετρική συνάρτηση</translation>
    </message>
    <message>
        <source>Same difference in a row</source>
        <translation>Ίδια διαφορά στη σειρά</translation>
    </message>
    <message>
        <source>Catch trials</source>
        <translation>Δοκιμές ελέγχου</translation>
    </message>
    <message>
        <source>Values of this parameter that are considered possible.</source>
        <translation>Τιμές αυτής της παραμέτρου που θεωρούνται πιθανές.</translation>
    </message>
    <message>
        <source>QUEST+</source>
        <translation>QUEST+</translation>
    </message>
    <message>
        <source>Bayesian; chooses the trial that tells most about threshold, slope and lapse rate.</source>
        <translation>Μπεϋζιανή· επιλέγει τη δοκιμή που δίνει τις περισσότερες πληροφορίες για κατώφλι, κλίση και ποσοστό αβλεψιών.</translation>
    </message>
    <message>
        <source>Shares of careless answers that are considered possible.</source>
        <translation>Ποσοστά απρόσεκτων απαντήσεων που θεωρούνται πιθανά.</translation>
    </message>
    <message>
        <source>Ties (in σ)</source>
        <translation>Ισοβαθμίες (σε σ)</translation>
    </message>
    <message>
        <source>Just noticeable difference</source>
        <translation>Ελάχιστη αντιληπτή διαφορά</translation>
    </message>
    <message>
        <source>QUEST+ for rankings</source>
        <translation>QUEST+ για κατατάξεις</translation>
    </message>
    <message>
        <source>QUEST+ with an observer model for rankings of three. Needs the fewest trials; the default.</source>
        <translation>QUEST+ με μοντέλο παρατηρητή για κατατάξεις τριών. Χρειάζεται τις λιγότερες δοκιμές· η προεπιλογή.</translation>
    </message>
    <message>
        <source>Where the run begins: large enough to be felt by everybody. It must lie in the table of differences.</source>
        <translation>Από πού αρχίζει η εκτέλεση: αρκετά μεγάλη ώστε να την αισθάνονται όλοι. Πρέπει να βρίσκεται στον πίνακα διαφορών.</translation>
    </message>
    <message>
        <source>Right answers for a step down</source>
        <translation>Σωστές απαντήσεις για βήμα προς τα κάτω</translation>
    </message>
    <message>
        <source>Wrong answers for a step up</source>
        <translation>Λάθος απαντήσεις για βήμα προς τα πάνω</translation>
    </message>
    <message>
        <source>Step down as a share of a step up</source>
        <translation>Βήμα προς τα κάτω ως ποσοστό του βήματος προς τα πάνω</translation>
    </message>
    <message>
        <source>Steps down are usually smaller than steps up, so that the run converges: 73.93 % for three right answers (García-Pérez 1998).</source>
        <translation>Τα βήματα προς τα κάτω είναι συνήθως μικρότερα από τα βήματα προς τα πάνω, ώστε να συγκλίνει η εκτέλεση: 73,93 % για τρεις σωστές απαντήσεις (García-Pérez 1998).</translation>
    </message>
    <message>
        <source>as listed</source>
        <translation>όπως στον κατάλογο</translation>
    </message>
    <message>
        <source>Reversals averaged</source>
        <translation>Αναστροφές στον μέσο όρο</translation>
    </message>
    <message>
        <source>Steps up</source>
        <translation>Βήματα προς τα πάνω</translation>
    </message>
    <message>
        <source>Steps down</source>
        <translation>Βήματα προς τα κάτω</translation>
    </message>
    <message>
        <source>One up, one down at first</source>
        <translation>Αρχικά ένα πάνω, ένα κάτω</translation>
    </message>
    <message>
        <source>After each step, right and wrong answers are counted from zero.</source>
        <translation>Μετά από κάθε βήμα η καταμέτρηση σωστών και λανθασμένων απαντήσεων αρχίζει από το μηδέν.</translation>
    </message>
    <message>
        <source>New step size at the reversal</source>
        <translation>Νέο βήμα στην αναστροφή</translation>
    </message>
    <message>
        <source>The step that makes the reversal already has the new size.</source>
        <translation>Το βήμα που κάνει την αναστροφή έχει ήδη το νέο μέγεθος.</translation>
    </message>
    <message>
        <source>Stay within the table</source>
        <translation>Παραμονή στον πίνακα</translation>
    </message>
    <message>
        <source>The run never asks for differences beyond the smallest and largest.</source>
        <translation>Η εκτέλεση δεν ζητά ποτέ διαφορές πέρα από τη μικρότερη και τη μεγαλύτερη.</translation>
    </message>
    <message>
        <source>Staircase (up–down)</source>
        <translation>Κλιμακωτή (πάνω–κάτω)</translation>
    </message>
    <message>
        <source>Gets harder after right answers and easier after wrong ones. Robust and easy to explain.</source>
        <translation>Γίνεται δυσκολότερη μετά από σωστές και ευκολότερη μετά από λάθος απαντήσεις. Ανθεκτική και εύκολη στην εξήγηση.</translation>
    </message>
    <message>
        <source>How often each level is presented.</source>
        <translation>Πόσες φορές παρουσιάζεται κάθε επίπεδο.</translation>
    </message>
    <message>
        <source>Levels come in random order, each once in every block; otherwise in the order of the table.</source>
        <translation>Τα επίπεδα παρουσιάζονται με τυχαία σειρά, το καθένα μία φορά σε κάθε μπλοκ· αλλιώς με τη σειρά του πίνακα.</translation>
    </message>
    <message>
        <source>How often each level is presented before the run goes on or ends.</source>
        <translation>Πόσες φορές παρουσιάζεται κάθε επίπεδο πριν η εκτέλεση συνεχίσει ή τελειώσει.</translation>
    </message>
    <message>
        <source>The run ends once the direction has changed this many times; 0: only the number of trials ends it.</source>
        <translation>Η εκτέλεση τελειώνει όταν η φορά αλλάξει τόσες φορές· 0: την τερματίζει μόνο ο αριθμός των δοκιμών.</translation>
    </message>
    <message>
        <source>Stop at this precision</source>
        <translation>Τέλος με αυτή την ακρίβεια</translation>
    </message>
    <message>
        <source>Target share of right answers</source>
        <translation>Επιδιωκόμενο ποσοστό σωστών απαντήσεων</translation>
    </message>
    <message>
        <source>The run looks for the difference at which this share of the answers is right.</source>
        <translation>Η εκτέλεση αναζητά τη διαφορά στην οποία αυτό το ποσοστό των απαντήσεων είναι σωστό.</translation>
    </message>
    <message>
        <source>Tolerated deviation</source>
        <translation>Ανεκτή απόκλιση</translation>
    </message>
    <message>
        <source>The threshold is the difference at which this share of the answers is right.</source>
        <translation>Το κατώφλι είναι η διαφορά στην οποία αυτό το ποσοστό των απαντήσεων είναι σωστό.</translation>
    </message>
    <message>
        <source>Where on the posterior distribution the next trial is placed; the quantile is the most efficient.</source>
        <translation>Σε ποιο σημείο της εκ των υστέρων κατανομής τοποθετείται η επόμενη δοκιμή· το ποσοστημόριο είναι το αποδοτικότερο.</translation>
    </message>
    <message>
        <source>Change of the function</source>
        <translation>Αλλαγή της συνάρτησης</translation>
    </message>
    <message>
        <source>How many of the last reversals are averaged for the staircase&apos;s own estimate; the fit uses all trials.</source>
        <translation>Από πόσες τελευταίες αναστροφές υπολογίζεται ο μέσος όρος που η ίδια η κλιμακωτή μέθοδος δίνει ως εκτίμηση· η προσαρμογή χρησιμοποιεί όλες τις δοκιμές.</translation>
    </message>
    <message>
        <source>Start counting again after each step</source>
        <translation>Νέα καταμέτρηση μετά από κάθε βήμα</translation>
    </message>
    <message>
        <source>The run ends after this number of trials at the latest; 0: no limit. With fewer than 20 trials, runs are marked as short, and many give no usable value.</source>
        <translation>Η εκτέλεση τελειώνει το αργότερο μετά από αυτόν τον αριθμό δοκιμών· 0: χωρίς όριο. Με λιγότερες από 20 δοκιμές οι εκτελέσεις σημειώνονται ως σύντομες, και πολλές δεν δίνουν αξιοποιήσιμη τιμή.</translation>
    </message>
    <message>
        <source>The run does not end earlier, however sure the estimate is; 0: no minimum. It matters only where the run stops at a set precision.</source>
        <translation>Η εκτέλεση δεν τελειώνει νωρίτερα, όσο βέβαιη κι αν είναι η εκτίμηση· 0: χωρίς ελάχιστο. Έχει σημασία μόνο όταν η εκτέλεση τελειώνει σε ορισμένη ακρίβεια.</translation>
    </message>
    <message>
        <source>Uncertainty of the expectation</source>
        <translation>Αβεβαιότητα της πρόβλεψης</translation>
    </message>
    <message>
        <source>How steeply the share of right answers grows with the difference; it is assumed, not measured.</source>
        <translation>Πόσο απότομα αυξάνεται το ποσοστό σωστών απαντήσεων με τη διαφορά· θεωρείται δεδομένο, δεν μετριέται.</translation>
    </message>
    <message>
        <source>Share of answers that are wrong although the difference is felt.</source>
        <translation>Ποσοστό απαντήσεων που είναι λανθασμένες, αν και η διαφορά γίνεται αισθητή.</translation>
    </message>
    <message>
        <source>Share of answers that are right although nothing is felt: 50 % with two alternatives.</source>
        <translation>Ποσοστό απαντήσεων που είναι σωστές χωρίς καμία αίσθηση: 50 % με δύο εναλλακτικές.</translation>
    </message>
    <message>
        <source>How the share of right answers is assumed to grow with the difference.</source>
        <translation>Πώς θεωρείται ότι αυξάνεται το ποσοστό σωστών απαντήσεων με τη διαφορά.</translation>
    </message>
    <message>
        <source>The same difference is presented at most this many times in a row; 0: no limit.</source>
        <translation>Η ίδια διαφορά παρουσιάζεται το πολύ τόσες φορές στη σειρά· 0: χωρίς όριο.</translation>
    </message>
    <message>
        <source>Share of trials with the largest difference, which show whether a participant pays attention.</source>
        <translation>Ποσοστό δοκιμών με τη μεγαλύτερη διαφορά, που δείχνουν αν το άτομο προσέχει.</translation>
    </message>
    <message>
        <source>Values of the limit that are considered possible: two objects are called equal when the difference felt is below it. In standard deviations of what is felt.</source>
        <translation>Τιμές του ορίου που θεωρούνται πιθανές: δύο αντικείμενα θεωρούνται ίσα όταν η διαφορά που γίνεται αισθητή είναι μικρότερη. Σε τυπικές αποκλίσεις της αίσθησης.</translation>
    </message>
    <message>
        <source>The just noticeable difference is assumed to lie between these two values.</source>
        <translation>Θεωρείται ότι η ελάχιστη αντιληπτή διαφορά βρίσκεται μεταξύ αυτών των δύο τιμών.</translation>
    </message>
    <message>
        <source>After this many right answers in a row the next trial is harder; with 3 the run converges at about 80 % right answers.</source>
        <translation>Μετά από τόσες συνεχόμενες σωστές απαντήσεις η επόμενη δοκιμή είναι δυσκολότερη· με 3 η εκτέλεση συγκλίνει περίπου στο 80 % σωστών απαντήσεων.</translation>
    </message>
    <message>
        <source>After this many wrong answers in a row the next trial is easier.</source>
        <translation>Μετά από τόσες συνεχόμενες λανθασμένες απαντήσεις η επόμενη δοκιμή είναι ευκολότερη.</translation>
    </message>
    <message>
        <source>The first step is used until the first reversal, then the next one after each reversal; the last one stays in use.</source>
        <translation>Το πρώτο ισχύει ως την πρώτη αναστροφή και μετά από κάθε αναστροφή το επόμενο· το τελευταίο παραμένει σε ισχύ.</translation>
    </message>
    <message>
        <source>Until the first reversal a single right answer makes the next trial harder, so that the run gets near the threshold sooner.</source>
        <translation>Ως την πρώτη αναστροφή μία σωστή απάντηση αρκεί για να δυσκολέψει η επόμενη δοκιμή, ώστε η εκτέλεση να πλησιάσει νωρίτερα το κατώφλι.</translation>
    </message>
    <message>
        <source>A level ends once the number of right answers differs from the expected one by more than this. Larger values take longer and make the decision more reliable.</source>
        <translation>Ένα επίπεδο τελειώνει μόλις το πλήθος των σωστών απαντήσεων διαφέρει από το αναμενόμενο περισσότερο από αυτή την τιμή. Με μεγαλύτερες τιμές διαρκεί περισσότερο και η απόφαση είναι πιο αξιόπιστη.</translation>
    </message>
    <message>
        <source>In the same order as the steps up. Without an entry, the steps down are as large as the steps up.</source>
        <translation>Με την ίδια σειρά όπως τα βήματα προς τα πάνω. Χωρίς καταχώριση, τα βήματα προς τα κάτω είναι ίσα με τα βήματα προς τα πάνω.</translation>
    </message>
</context>
<context>
    <name>QDialogButtonBox</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation>Αναζήτηση σε:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>Ό&amp;νομα αρχείου:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Τύπος αρχείων:</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Φάκελος:</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Άν&amp;οιγμα</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Αποθήκευση</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Επιλογή</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Πίσω</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Μπροστά</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Γονικός φάκελος</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Νέος φάκελος</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Προβολή λίστας</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Προβολή λεπτομερειών</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>Το %1 υπάρχει ήδη.
Θέλετε να το αντικαταστήσετε;</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Όνομα</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Μέγεθος</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Τροποποιήθηκε</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>Αναί&amp;ρεση</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Επανάληψη</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Αποκο&amp;πή</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Αντιγραφή</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Επικό&amp;λληση</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Διαγραφή</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Επιλογή όλων</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Άκυρο</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Κλείσιμο</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ναι</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>Ό&amp;χι</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Αποθήκευση</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Άνοιγμα</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Απόρριψη</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Επανάληψη</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Εφαρμογή</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Βοήθεια</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Shift</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Αριστερά</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Δεξιά</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Πάνω</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Κάτω</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Διάστημα</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>End</source>
        <translation>End</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Page Up</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Page Down</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Delete</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>Αναί&amp;ρεση</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Επανάληψη</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>Αποκο&amp;πή</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Αντιγραφή</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>Επικό&amp;λληση</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Διαγραφή</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Επιλογή όλων</translation>
    </message>
</context>
<context>
    <name>Results</name>
    <message>
        <source>My results</source>
        <translation>Τα αποτελέσματά μου</translation>
    </message>
    <message>
        <source>Results of %1</source>
        <translation>Αποτελέσματα: %1</translation>
    </message>
</context>
<context>
    <name>RocWords</name>
    <message>
        <source>Area under the curve: %1, where 0.5 is chance and 1 is perfect. Sessions: %2 (%3). Places with a lump: %4, without: %5.</source>
        <translation>Εμβαδόν κάτω από την καμπύλη: %1· το 0,5 σημαίνει τύχη, το 1 τέλεια διάκριση. Συνεδρίες: %2 (%3). Θέσεις με όζο: %4, χωρίς: %5.</translation>
    </message>
    <message>
        <source>force felt</source>
        <translation>αισθητή δύναμη</translation>
    </message>
    <message>
        <source>force shown</source>
        <translation>μόνο προβολή δύναμης</translation>
    </message>
    <message>
        <source>Hits against false alarms, from certain to a guess</source>
        <translation>Επιτυχίες ως προς τους ψευδείς συναγερμούς, από βεβαιότητα έως εικασία</translation>
    </message>
    <message>
        <source>False alarm rate</source>
        <translation>Ποσοστό ψευδών συναγερμών</translation>
    </message>
    <message>
        <source>Hit rate</source>
        <translation>Ποσοστό επιτυχιών</translation>
    </message>
    <message>
        <source>chance</source>
        <translation>τύχη</translation>
    </message>
    <message>
        <source>you</source>
        <translation>εσείς</translation>
    </message>
</context>
<context>
    <name>RosterTemplate</name>
    <message>
        <source>Full name</source>
        <translation>Πλήρες όνομα</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Όνομα χρήστη</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Ρόλος</translation>
    </message>
    <message>
        <source>Example: Anna Miller</source>
        <translation>Παράδειγμα: Άννα Παππά</translation>
    </message>
    <message>
        <source>Example: Peter Brown</source>
        <translation>Παράδειγμα: Πέτρος Νικολάου</translation>
    </message>
</context>
<context>
    <name>RosterWords</name>
    <message>
        <source>a quotation mark is opened here and never closed</source>
        <translation>εδώ ανοίγουν εισαγωγικά που δεν κλείνουν</translation>
    </message>
    <message>
        <source>too many lines, %1 at most</source>
        <translation>πάρα πολλές γραμμές, το πολύ %1</translation>
    </message>
    <message>
        <source>the password needs at least %1 characters, %2 of them different, and must not be the name</source>
        <translation>ο κωδικός πρόσβασης χρειάζεται τουλάχιστον %1 χαρακτήρες, από αυτούς %2 διαφορετικούς, και δεν μπορεί να είναι το όνομα</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is already in line %2</source>
        <translation>το «%1» υπάρχει ήδη στη γραμμή %2</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Γραμμή %1: %2</translation>
    </message>
    <message>
        <source>semicolons</source>
        <translation>ελληνικά ερωτηματικά</translation>
    </message>
    <message>
        <source>commas</source>
        <translation>κόμματα</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>στηλοθέτες</translation>
    </message>
    <message>
        <source>Nothing to change</source>
        <translation>Καμία αλλαγή</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Read as %1, separated by %2.</source>
        <translation>Διαβάστηκε ως %1, με διαχωριστικό: %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n people would be added. Each must choose a password of their own at the first login.</source>
        <translation>
            <numerusform>Θα προστεθεί %n άτομο. Πρέπει να επιλέξει δικό του κωδικό πρόσβασης στην πρώτη σύνδεση.</numerusform>
            <numerusform>Θα προστεθούν %n άτομα. Καθένα πρέπει να επιλέξει δικό του κωδικό πρόσβασης στην πρώτη σύνδεση.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people would be updated; their passwords remain valid.</source>
        <translation>
            <numerusform>Θα ενημερωθεί %n άτομο· ο κωδικός πρόσβασής του ισχύει και μετά.</numerusform>
            <numerusform>Θα ενημερωθούν %n άτομα· οι κωδικοί πρόσβασής τους ισχύουν και μετά.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people have an account already and would be left as they are.</source>
        <translation>
            <numerusform>%n άτομο έχει ήδη λογαριασμό και θα μείνει ως έχει.</numerusform>
            <numerusform>%n άτομα έχουν ήδη λογαριασμό και θα μείνουν ως έχουν.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passwords would be made. They are shown once, right after the import, to be printed as slips.</source>
        <translation>
            <numerusform>Θα δημιουργηθεί %n κωδικός πρόσβασης. Εμφανίζεται μία φορά, αμέσως μετά την εισαγωγή, για να τυπωθεί σε σημείωμα.</numerusform>
            <numerusform>Θα δημιουργηθούν %n κωδικοί πρόσβασης. Εμφανίζονται μία φορά, αμέσως μετά την εισαγωγή, για να τυπωθούν σε σημειώματα.</numerusform>
        </translation>
    </message>
    <message>
        <source>Columns that are not imported: %1.</source>
        <translation>Στήλες που δεν εισάγονται: %1.</translation>
    </message>
    <message>
        <source>People in the list</source>
        <translation>Άτομα στη λίστα</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Γραμμή</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>Τι γίνεται</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Όνομα χρήστη</translation>
    </message>
    <message>
        <source>Full name</source>
        <translation>Πλήρες όνομα</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Ρόλοι</translation>
    </message>
    <message>
        <source>This is an Excel workbook (.xlsx). Open it in Excel, choose File &gt; Save As and the file type “CSV UTF-8 (comma delimited)”, then choose the new file here.</source>
        <translation>Αυτό είναι βιβλίο εργασίας του Excel (.xlsx). Ανοίξτε το στο Excel, επιλέξτε Αρχείο &gt; Αποθήκευση ως και τύπο αρχείου «CSV UTF-8 (οριοθετημένο με κόμμα)» και μετά επιλέξτε εδώ το νέο αρχείο.</translation>
    </message>
    <message>
        <source>This is an old Excel workbook (.xls). Open it in Excel, choose File &gt; Save As and the file type “CSV UTF-8 (comma delimited)”, then choose the new file here.</source>
        <translation>Αυτό είναι παλιό βιβλίο εργασίας του Excel (.xls). Ανοίξτε το στο Excel, επιλέξτε Αρχείο &gt; Αποθήκευση ως και τύπο αρχείου «CSV UTF-8 (οριοθετημένο με κόμμα)» και μετά επιλέξτε εδώ το νέο αρχείο.</translation>
    </message>
    <message>
        <source>This is a LibreOffice spreadsheet (.ods). Open it in LibreOffice, choose File &gt; Save As and the file type “Text CSV”, then choose the new file here.</source>
        <translation>Αυτό είναι υπολογιστικό φύλλο του LibreOffice (.ods). Ανοίξτε το στο LibreOffice, επιλέξτε Αρχείο &gt; Αποθήκευση ως και τύπο αρχείου «Κείμενο CSV» και μετά επιλέξτε εδώ το νέο αρχείο.</translation>
    </message>
    <message>
        <source>This is a PDF, which has no columns to read. Ask for the list as a table, save it as CSV, then choose that file here.</source>
        <translation>Αυτό είναι PDF και δεν έχει στήλες που διαβάζονται. Ζητήστε τη λίστα ως πίνακα, αποθηκεύστε την ως CSV και μετά επιλέξτε εδώ εκείνο το αρχείο.</translation>
    </message>
    <message>
        <source>This is a ZIP archive. Unpack it and choose the CSV file in it.</source>
        <translation>Αυτό είναι αρχείο ZIP. Αποσυμπιέστε το και επιλέξτε το αρχείο CSV που περιέχει.</translation>
    </message>
    <message>
        <source>some letters cannot be read; save the list as “CSV UTF-8” once more</source>
        <translation>μερικά γράμματα δεν διαβάζονται· αποθηκεύστε ξανά τη λίστα ως «CSV UTF-8»</translation>
    </message>
    <message>
        <source>a line with headings and at least one person are needed</source>
        <translation>χρειάζονται μία γραμμή με επικεφαλίδες και τουλάχιστον ένα άτομο</translation>
    </message>
    <message>
        <source>headings are needed here, such as login name, full name and role; &quot;%1&quot; is none of them. “Save a template …” makes a file that has them</source>
        <translation>εδώ χρειάζονται επικεφαλίδες όπως Όνομα χρήστη, Πλήρες όνομα και Ρόλος· το «%1» δεν είναι καμία από αυτές. Η «Αποθήκευση προτύπου …» φτιάχνει αρχείο που τις έχει</translation>
    </message>
    <message>
        <source>the column &quot;%1&quot; holds what another column holds already</source>
        <translation>η στήλη «%1» περιέχει ό,τι περιέχει ήδη άλλη στήλη</translation>
    </message>
    <message>
        <source>no column holds the roles; give one the heading “Role”</source>
        <translation>καμία στήλη δεν περιέχει τους ρόλους· δώστε σε μία την επικεφαλίδα «Ρόλος»</translation>
    </message>
    <message>
        <source>no column holds the login name; give one the heading “Login name”</source>
        <translation>καμία στήλη δεν περιέχει το όνομα χρήστη· δώστε σε μία την επικεφαλίδα «Όνομα χρήστη»</translation>
    </message>
    <message>
        <source>has %1 fields, and there are %2 headings; put a value that holds the separator into quotation marks</source>
        <translation>έχει %1 πεδία, ενώ οι επικεφαλίδες είναι %2· βάλτε σε εισαγωγικά μια τιμή που περιέχει το διαχωριστικό</translation>
    </message>
    <message>
        <source>a login name is needed</source>
        <translation>χρειάζεται όνομα χρήστη</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be used; use at most %2 characters and no commas</source>
        <translation>το «%1» δεν επιτρέπεται· χρησιμοποιήστε το πολύ %2 χαρακτήρες και όχι κόμματα</translation>
    </message>
    <message>
        <source>the full name is too long; use at most %1 characters</source>
        <translation>το πλήρες όνομα είναι πολύ μεγάλο· χρησιμοποιήστε το πολύ %1 χαρακτήρες</translation>
    </message>
    <message>
        <source>Line %1, column “%2”: %3</source>
        <translation>Γραμμή %1, στήλη «%2»: %3</translation>
    </message>
    <message numerus="yes">
        <source>%n people would no longer be administrators.</source>
        <translation>
            <numerusform>%n άτομο δεν θα ήταν πλέον διαχειριστής.</numerusform>
            <numerusform>%n άτομα δεν θα ήταν πλέον διαχειριστές.</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1: the login name %2 belongs to %3 today; it used to be that of %4. Check who is meant.</source>
        <translation>Γραμμή %1: το όνομα χρήστη %2 ανήκει σήμερα σε: %3· παλιότερα το είχε: %4. Ελέγξτε ποιος εννοείται.</translation>
    </message>
    <message>
        <source>Line %1: several people had the login name %2 before and nobody has it today, so nobody is changed. Write today&apos;s login name in the list.</source>
        <translation>Γραμμή %1: το όνομα χρήστη %2 το είχαν παλιότερα πολλά άτομα και σήμερα κανείς, γι&apos; αυτό δεν αλλάζει κανείς. Γράψτε στη λίστα το σημερινό όνομα χρήστη.</translation>
    </message>
    <message>
        <source>Line %1: this is the same person as in line %2, under another login name. Only line %2 counts.</source>
        <translation>Γραμμή %1: είναι το ίδιο άτομο με τη γραμμή %2, με άλλο όνομα χρήστη. Μετρά μόνο η γραμμή %2.</translation>
    </message>
    <message>
        <source>%1, known as %2 today</source>
        <translation>%1, σήμερα γνωστός/-ή ως %2</translation>
    </message>
    <message numerus="yes">
        <source>%n people are listed under an earlier login name and are recognised by it.</source>
        <translation>
            <numerusform>%n άτομο είναι στη λίστα με παλιότερο όνομα χρήστη και αναγνωρίζεται από αυτό.</numerusform>
            <numerusform>%n άτομα είναι στη λίστα με παλιότερο όνομα χρήστη και αναγνωρίζονται από αυτό.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is not certain who is meant in %n more lines. Point at the login name in the table to read why.</source>
        <translation>
            <numerusform>Σε %n ακόμη γραμμή δεν είναι βέβαιο ποιος εννοείται. Δείξτε το όνομα χρήστη στον πίνακα για να διαβάσετε τον λόγο.</numerusform>
            <numerusform>Σε %n ακόμη γραμμές δεν είναι βέβαιο ποιος εννοείται. Δείξτε το όνομα χρήστη στον πίνακα για να διαβάσετε τον λόγο.</numerusform>
        </translation>
    </message>
    <message>
        <source>The list has the earlier full name %1; today&apos;s name stays.</source>
        <translation>Η λίστα έχει το παλιότερο ονοματεπώνυμο %1· μένει το σημερινό.</translation>
    </message>
    <message>
        <source>%1 would be called %2.</source>
        <translation>Το όνομα %1 θα γίνει %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n people are listed under an earlier full name and keep today&apos;s name. To give somebody an earlier name back, edit the person.</source>
        <translation>
            <numerusform>%n άτομο είναι στη λίστα με παλιότερο ονοματεπώνυμο και κρατά το σημερινό. Για να επαναφέρετε το παλιότερο, επεξεργαστείτε το άτομο.</numerusform>
            <numerusform>%n άτομα είναι στη λίστα με παλιότερο ονοματεπώνυμο και κρατούν το σημερινό. Για να επαναφέρετε ένα παλιότερο, επεξεργαστείτε το άτομο.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing to import: everybody on the list is already here.</source>
        <translation>Δεν υπάρχει τίποτα για εισαγωγή: όλοι στη λίστα είναι ήδη εδώ.</translation>
    </message>
    <message>
        <source>Would be added</source>
        <translation>Θα προστεθεί</translation>
    </message>
    <message>
        <source>Would be left as it is</source>
        <translation>Θα μείνει ως έχει</translation>
    </message>
    <message>
        <source>Would be updated</source>
        <translation>Θα ενημερωθεί</translation>
    </message>
    <message>
        <source>Cannot be imported yet</source>
        <translation>Δεν εισάγεται ακόμη</translation>
    </message>
    <message numerus="yes">
        <source>%n more people would get a different full name; the table shows them.</source>
        <translation>
            <numerusform>%n ακόμη άτομο θα πάρει άλλο ονοματεπώνυμο· φαίνεται στον πίνακα.</numerusform>
            <numerusform>%n ακόμη άτομα θα πάρουν άλλο ονοματεπώνυμο· φαίνονται στον πίνακα.</numerusform>
        </translation>
    </message>
    <message>
        <source>this is not a text file; a CSV file is needed</source>
        <translation>αυτό δεν είναι αρχείο κειμένου· χρειάζεται αρχείο CSV</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a role; write trainee, trainer, researcher or administrator, separated by semicolons</source>
        <translation>το «%1» δεν είναι ρόλος· γράψτε εκπαιδευόμενος, εκπαιδευτής, ερευνητής ή διαχειριστής, με «;» ανάμεσα</translation>
    </message>
</context>
<context>
    <name>Screens</name>
    <message>
        <source>Welcome</source>
        <translation>Καλωσορίσατε</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Σύνδεση</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Εκπαίδευση</translation>
    </message>
    <message>
        <source>My results</source>
        <translation>Αποτελέσματα</translation>
    </message>
    <message>
        <source>Debrief</source>
        <translation>Απολογισμός</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Αναπαραγωγή</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Ρυθμίσεις</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Αρχική</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Ασκήσεις</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Συνεδρίες</translation>
    </message>
    <message>
        <source>Storage</source>
        <translation>Φύλαξη</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Σταθμός</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Άσκηση</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Άτομα</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Μελέτες</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Μελέτη</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Διεξαγωγή</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Δεδομένα</translation>
    </message>
    <message>
        <source>Questionnaire</source>
        <translation>Ερωτηματολόγιο</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Δοκιμές</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>Επαναφορά αντιγράφου ασφαλείας</translation>
    </message>
    <message>
        <source>My account</source>
        <translation>Λογαριασμός</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Σχόλια</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Πρόοδος</translation>
    </message>
</context>
<context>
    <name>SessionWords</name>
    <message>
        <source>Running</source>
        <translation>Σε εξέλιξη</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Σταμάτησε</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Διακόπηκε</translation>
    </message>
    <message>
        <source>Incomplete</source>
        <translation>Ελλιπής</translation>
    </message>
    <message>
        <source>Faulted</source>
        <translation>Βλάβη</translation>
    </message>
    <message>
        <source>Voided</source>
        <translation>Ακυρώθηκε</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Επιτυχία</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Αποτυχία</translation>
    </message>
    <message>
        <source>Does not count</source>
        <translation>Δεν μετράει</translation>
    </message>
    <message>
        <source>Familiarisation</source>
        <translation>Εξοικείωση</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Αισθητή</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>μόλις τώρα</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>πριν από %n λεπτό</numerusform>
            <numerusform>πριν από %n λεπτά</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>πριν από %n ώρα</numerusform>
            <numerusform>πριν από %n ώρες</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>πριν από %n ημέρα</numerusform>
            <numerusform>πριν από %n ημέρες</numerusform>
        </translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Μελέτη</translation>
    </message>
    <message>
        <source>Own hand</source>
        <translation>Δικό του χέρι</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Προβαλλόμενη</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 από %2</translation>
    </message>
    <message>
        <source>Reviewed</source>
        <translation>Αξιολογήθηκε</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1, επίπεδο %2</translation>
    </message>
    <message>
        <source>Attempt %1 at level %2</source>
        <translation>Προσπάθεια %1 στο επίπεδο %2</translation>
    </message>
    <message>
        <source>%1, attempt %2 at level %3</source>
        <translation>%1, προσπάθεια %2 στο επίπεδο %3</translation>
    </message>
    <message>
        <source>To review</source>
        <translation>Προς αξιολόγηση</translation>
    </message>
</context>
<context>
    <name>Sessions</name>
    <message>
        <source>Running</source>
        <translation>Σε εξέλιξη</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Σταμάτησε</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Διακόπηκε</translation>
    </message>
    <message>
        <source>Incomplete</source>
        <translation>Ελλιπής</translation>
    </message>
    <message>
        <source>Faulted</source>
        <translation>Βλάβη</translation>
    </message>
    <message>
        <source>Voided</source>
        <translation>Ακυρώθηκε</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Επιτυχία</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Αποτυχία</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Αισθητή</translation>
    </message>
    <message>
        <source>Shown, not felt</source>
        <translation>Μόνο προβολή</translation>
    </message>
    <message>
        <source>Force felt</source>
        <translation>Αισθητή δύναμη</translation>
    </message>
    <message>
        <source>Force shown, not felt</source>
        <translation>Μόνο προβολή δύναμης</translation>
    </message>
    <message>
        <source>%1 (scripted)</source>
        <translation>%1 (προγραμματισμένο)</translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation>Επίπεδο %1</translation>
    </message>
    <message>
        <source>Level %1: %2</source>
        <translation>Επίπεδο %1: %2</translation>
    </message>
    <message>
        <source>Not counted</source>
        <translation>Δεν μετράει</translation>
    </message>
    <message>
        <source>Force rendered to a scripted hand</source>
        <translation>Δύναμη αποδόθηκε σε προγραμματισμένο χέρι</translation>
    </message>
</context>
<context>
    <name>SiteMaker</name>
    <message>
        <source>A study with simulated participants</source>
        <translation>Μια μελέτη με προσομοιωμένους συμμετέχοντες</translation>
    </message>
    <message>
        <source>%1, level %2, by a scripted operator</source>
        <translation>%1, επίπεδο %2, από προσομοιωμένο χειριστή</translation>
    </message>
    <message>
        <source>%1, level %2, by %3</source>
        <translation>%1, επίπεδο %2, από %3</translation>
    </message>
    <message>
        <source>%1, level %2, by %3, attempt %4 of %5</source>
        <translation>%1, επίπεδο %2, από %3, προσπάθεια %4 από %5</translation>
    </message>
</context>
<context>
    <name>SittingSentences</name>
    <message>
        <source>During the trials you hear a steady noise.</source>
        <translation>Κατά τις δοκιμές ακούτε έναν σταθερό θόρυβο.</translation>
    </message>
</context>
<context>
    <name>SoundLoader</name>
    <message>
        <source>Sound is switched off on this station. Everything that can be heard is also shown.</source>
        <translation>Ο ήχος είναι απενεργοποιημένος σε αυτόν τον σταθμό. Ό,τι ακούγεται φαίνεται και στην οθόνη.</translation>
    </message>
    <message>
        <source>The sound module of Chiron is not installed. Everything that can be heard is also shown.</source>
        <translation>Η μονάδα ήχου του Chiron δεν είναι εγκατεστημένη. Ό,τι ακούγεται φαίνεται και στην οθόνη.</translation>
    </message>
    <message>
        <source>The sound module belongs to another version of Chiron. Everything that can be heard is also shown.</source>
        <translation>Η μονάδα ήχου ανήκει σε άλλη έκδοση του Chiron. Ό,τι ακούγεται φαίνεται και στην οθόνη.</translation>
    </message>
    <message>
        <source>This station has no sound output. Everything that can be heard is also shown.</source>
        <translation>Αυτός ο σταθμός δεν έχει έξοδο ήχου. Ό,τι ακούγεται φαίνεται και στην οθόνη.</translation>
    </message>
</context>
<context>
    <name>StageWords</name>
    <message>
        <source>Inspection: %1 of %2 landmarks seen. Hold still</source>
        <translation>Επισκόπηση: φάνηκαν %1 από %2 οδηγά σημεία. Μην κινείστε</translation>
    </message>
    <message>
        <source>Inspection: %1 of %2 landmarks seen</source>
        <translation>Επισκόπηση: φάνηκαν %1 από %2 οδηγά σημεία</translation>
    </message>
    <message>
        <source>Before the entrance</source>
        <translation>Πριν από την είσοδο</translation>
    </message>
    <message>
        <source>Insertion</source>
        <translation>Εισαγωγή</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Επισκόπηση</translation>
    </message>
    <message>
        <source>Withdrawal</source>
        <translation>Απόσυρση</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>Before the entrance: advance into the urethra</source>
        <translation>Πριν από την είσοδο: προωθήστε το ενδοσκόπιο στην ουρήθρα</translation>
    </message>
    <message>
        <source>Insertion: %1 of %2 mm</source>
        <translation>Εισαγωγή: %1 από %2 mm</translation>
    </message>
    <message>
        <source>Insertion: on the way to the goal</source>
        <translation>Εισαγωγή: καθ’ οδόν προς τον στόχο</translation>
    </message>
    <message>
        <source>Withdrawal: bring the endoscope out, %1 mm more</source>
        <translation>Απόσυρση: βγάλτε το ενδοσκόπιο, ακόμη %1 mm</translation>
    </message>
    <message>
        <source>Withdrawal: bring the endoscope all the way out</source>
        <translation>Απόσυρση: βγάλτε εντελώς το ενδοσκόπιο</translation>
    </message>
</context>
<context>
    <name>StationRecord</name>
    <message>
        <source>pass</source>
        <translation>επιτυχία</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>ΑΠΟΤΥΧΙΑ</translation>
    </message>
    <message>
        <source>Measured values and their limits</source>
        <translation>Μετρημένες τιμές και όριά τους</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Μέγεθος</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Μετρήθηκε</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Όριο</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Αποτέλεσμα</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Κέντρο</translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation>Έλεγχος από</translation>
    </message>
    <message>
        <source>Date and time</source>
        <translation>Ημερομηνία και ώρα</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Σταθμός</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Συσκευή</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Αριθμός σειράς</translation>
    </message>
    <message>
        <source>none</source>
        <translation>κανένας</translation>
    </message>
    <message>
        <source>Program build</source>
        <translation>Έκδοση προγράμματος</translation>
    </message>
    <message>
        <source>Entry in the audit trail</source>
        <translation>Εγγραφή στο ημερολόγιο ελέγχου</translation>
    </message>
    <message>
        <source>not written</source>
        <translation>δεν γράφτηκε</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>δεν μετρήθηκε</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>χωρίς όριο</translation>
    </message>
    <message>
        <source>Ticks more than 100 µs late, of %1</source>
        <translation>Κύκλοι με καθυστέρηση άνω των 100 µs, από %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>το πολύ %1</translation>
    </message>
    <message>
        <source>Ticks skipped</source>
        <translation>Κύκλοι που παραλείφθηκαν</translation>
    </message>
    <message>
        <source>Lateness, half of the ticks</source>
        <translation>Καθυστέρηση, οι μισοί κύκλοι</translation>
    </message>
    <message>
        <source>Lateness, 99 of 100 ticks</source>
        <translation>Καθυστέρηση, 99 στους 100 κύκλους</translation>
    </message>
    <message>
        <source>Lateness, the latest tick</source>
        <translation>Καθυστέρηση, ο πιο καθυστερημένος κύκλος</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ναι</translation>
    </message>
    <message>
        <source>no</source>
        <translation>όχι</translation>
    </message>
    <message>
        <source>Real-time priority</source>
        <translation>Προτεραιότητα πραγματικού χρόνου</translation>
    </message>
    <message>
        <source>recommended</source>
        <translation>συνιστάται</translation>
    </message>
    <message>
        <source>Memory locked</source>
        <translation>Κλειδωμένη μνήμη</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message numerus="yes">
        <source>Measured values and their limits, the worst of %n finger(s)</source>
        <translation>
            <numerusform>Μετρημένες τιμές και όριά τους, σε %n δάχτυλο</numerusform>
            <numerusform>Μετρημένες τιμές και όριά τους, το χειρότερο από %n δάχτυλα</numerusform>
        </translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>κάτω από %1</translation>
    </message>
    <message>
        <source>Force error by the platform&apos;s own sensors (root mean square)</source>
        <translation>Σφάλμα δύναμης κατά τους αισθητήρες της πλατφόρμας (τετραγωνικός μέσος)</translation>
    </message>
    <message>
        <source>Force error on the finger pad (root mean square)</source>
        <translation>Σφάλμα δύναμης στο ακροδάχτυλο (τετραγωνικός μέσος)</translation>
    </message>
    <message>
        <source>Orientation error by the platform&apos;s own sensor</source>
        <translation>Σφάλμα προσανατολισμού κατά τον αισθητήρα της πλατφόρμας</translation>
    </message>
    <message>
        <source>Orientation error, true</source>
        <translation>Σφάλμα προσανατολισμού, πραγματικό</translation>
    </message>
    <message>
        <source>Overshoot of a step of force</source>
        <translation>Υπέρβαση σε απότομη αλλαγή δύναμης</translation>
    </message>
    <message>
        <source>Largest force on the finger pad</source>
        <translation>Μέγιστη δύναμη στο ακροδάχτυλο</translation>
    </message>
    <message>
        <source>Station check: timing of the force loop</source>
        <translation>Έλεγχος σταθμού: χρονισμός του βρόχου δύναμης</translation>
    </message>
    <message>
        <source>Passed. %1</source>
        <translation>Επιτυχία. %1</translation>
    </message>
    <message>
        <source>Failed. %1</source>
        <translation>Αποτυχία. %1</translation>
    </message>
    <message>
        <source>not reported by the device</source>
        <translation>δεν δηλώνεται από τη συσκευή</translation>
    </message>
</context>
<context>
    <name>StationWords</name>
    <message>
        <source>Force is felt</source>
        <translation>Η δύναμη γίνεται αισθητή</translation>
    </message>
    <message>
        <source>Force is shown, not felt</source>
        <translation>Η δύναμη προβάλλεται, δεν γίνεται αισθητή</translation>
    </message>
    <message>
        <source>The force loop has real-time priority.</source>
        <translation>Ο βρόχος δύναμης έχει προτεραιότητα πραγματικού χρόνου.</translation>
    </message>
    <message>
        <source>The force loop has no real-time priority: under load, touch may feel rough.</source>
        <translation>Ο βρόχος δύναμης δεν έχει προτεραιότητα πραγματικού χρόνου: υπό φόρτο η αφή μπορεί να γίνει τραχιά.</translation>
    </message>
    <message>
        <source>To permit it, the administrator of this computer adds two lines to a file in /etc/security/limits.d, where &quot;group&quot; is the group of those who train: &quot;@group - rtprio 80&quot; and &quot;@group - memlock unlimited&quot;. It takes effect at the next login to the computer.</source>
        <translation>Για να επιτραπεί, ο διαχειριστής αυτού του υπολογιστή προσθέτει δύο γραμμές σε ένα αρχείο στο /etc/security/limits.d, όπου «group» είναι η ομάδα όσων εκπαιδεύονται: «@group - rtprio 80» και «@group - memlock unlimited». Ισχύει από την επόμενη σύνδεση στον υπολογιστή.</translation>
    </message>
    <message>
        <source>Memory is locked: nothing the loop needs can be swapped out.</source>
        <translation>Η μνήμη είναι κλειδωμένη: τίποτα από όσα χρειάζεται ο βρόχος δεν μεταφέρεται στον δίσκο.</translation>
    </message>
    <message>
        <source>Memory is not locked: when it runs short, the loop may have to wait for the disk.</source>
        <translation>Η μνήμη δεν είναι κλειδωμένη: όταν λείπει μνήμη, ο βρόχος ίσως περιμένει τον δίσκο.</translation>
    </message>
    <message>
        <source>%1 ticks of 1 ms. Half of them started within %2 µs, 99 of 100 within %3 µs, the latest after %4 µs. %5 were more than 100 µs late, %6 were skipped.</source>
        <translation>%1 κύκλοι του 1 ms. Οι μισοί άρχισαν μέσα σε %2 µs, 99 στους 100 μέσα σε %3 µs, ο πιο καθυστερημένος μετά από %4 µs. %5 καθυστέρησαν πάνω από 100 µs, %6 παραλείφθηκαν.</translation>
    </message>
    <message numerus="yes">
        <source>The loop does not run on time: %n tick(s) were skipped. Close other programs, or permit real-time priority.</source>
        <translation>
            <numerusform>Ο βρόχος δεν τηρεί τον χρόνο: παραλείφθηκε %n κύκλος. Κλείστε άλλα προγράμματα ή επιτρέψτε προτεραιότητα πραγματικού χρόνου.</numerusform>
            <numerusform>Ο βρόχος δεν τηρεί τον χρόνο: παραλείφθηκαν %n κύκλοι. Κλείστε άλλα προγράμματα ή επιτρέψτε προτεραιότητα πραγματικού χρόνου.</numerusform>
        </translation>
    </message>
    <message>
        <source>The loop runs on time: %1 % of the ticks were late (limit %2 %), and none was skipped.</source>
        <translation>Ο βρόχος τηρεί τον χρόνο: το %1 % των κύκλων καθυστέρησε (όριο %2 %) και κανένας δεν παραλείφθηκε.</translation>
    </message>
    <message>
        <source>The loop does not run on time: %1 % of the ticks were late (limit %2 %). Close other programs, or permit real-time priority.</source>
        <translation>Ο βρόχος δεν τηρεί τον χρόνο: το %1 % των κύκλων καθυστέρησε (όριο %2 %). Κλείστε άλλα προγράμματα ή επιτρέψτε προτεραιότητα πραγματικού χρόνου.</translation>
    </message>
</context>
<context>
    <name>StorageWords</name>
    <message>
        <source>The disk is full: only %1 is free. Sessions might not be saved. Free up space before anybody trains.</source>
        <translation>Ο δίσκος είναι γεμάτος: ελεύθερα %1. Οι συνεδρίες ίσως δεν αποθηκευτούν. Ελευθερώστε χώρο πριν εκπαιδευτεί κάποιος.</translation>
    </message>
    <message>
        <source>There is no room for the safety copy of a running session (%1 needed, %2 free in memory). Sessions cannot start. Close other programs.</source>
        <translation>Δεν υπάρχει χώρος για το εφεδρικό αντίγραφο μιας συνεδρίας σε εξέλιξη (χρειάζονται %1, ελεύθερα στη μνήμη %2). Οι συνεδρίες δεν θα ξεκινούν. Κλείστε άλλα προγράμματα.</translation>
    </message>
    <message>
        <source>The disk is getting full: %1 is free. Sessions can still be recorded. Free up space, or move backups to another disk.</source>
        <translation>Ο δίσκος γεμίζει: ελεύθερα %1. Οι συνεδρίες καταγράφονται ακόμη. Ελευθερώστε χώρο ή μεταφέρετε αντίγραφα ασφαλείας σε άλλον δίσκο.</translation>
    </message>
    <message>
        <source>Memory for the safety copy of running sessions is running low: %1 is free.</source>
        <translation>Η μνήμη για το εφεδρικό αντίγραφο των συνεδριών σε εξέλιξη λιγοστεύει: ελεύθερα %1.</translation>
    </message>
    <message>
        <source>There is enough room: %1 is free.</source>
        <translation>Υπάρχει αρκετός χώρος: ελεύθερα %1.</translation>
    </message>
    <message>
        <source>There is no backup yet. What is recorded exists only once.</source>
        <translation>Δεν υπάρχει ακόμη αντίγραφο ασφαλείας. Όσα έχουν καταγραφεί υπάρχουν μόνο μία φορά.</translation>
    </message>
    <message>
        <source>The last backup was made %1. Make a new one.</source>
        <translation>Το τελευταίο αντίγραφο ασφαλείας έγινε %1. Δημιουργήστε νέο.</translation>
    </message>
    <message>
        <source>The last backup was made %1.</source>
        <translation>Το τελευταίο αντίγραφο ασφαλείας έγινε %1.</translation>
    </message>
    <message>
        <source>The file is damaged</source>
        <translation>Το αρχείο έχει υποστεί βλάβη</translation>
    </message>
    <message>
        <source>A record was changed</source>
        <translation>Μια εγγραφή άλλαξε</translation>
    </message>
    <message>
        <source>Recorded data was changed</source>
        <translation>Καταγεγραμμένα δεδομένα άλλαξαν</translation>
    </message>
    <message>
        <source>Something is missing</source>
        <translation>Κάτι λείπει</translation>
    </message>
    <message>
        <source>It cannot be read</source>
        <translation>Δεν διαβάζεται</translation>
    </message>
    <message>
        <source>A session was changed after it ended</source>
        <translation>Μια συνεδρία άλλαξε μετά τη λήξη της</translation>
    </message>
    <message>
        <source>The audit trail is not intact</source>
        <translation>Το ημερολόγιο ελέγχου δεν είναι ακέραιο</translation>
    </message>
    <message>
        <source>A score does not match its recording</source>
        <translation>Μια βαθμολογία δεν συμφωνεί με την καταγραφή της</translation>
    </message>
    <message>
        <source>Something is wrong</source>
        <translation>Κάτι δεν είναι σωστό</translation>
    </message>
    <message numerus="yes">
        <source>The check found %n error(s). Nothing was changed. Keep this database as it is and restore a backup that passes the check.</source>
        <translation>
            <numerusform>Βρέθηκε %n πρόβλημα. Τίποτα δεν άλλαξε. Κρατήστε αυτή τη βάση δεδομένων όπως είναι και επαναφέρετε ένα αντίγραφο ασφαλείας που περνά τον έλεγχο.</numerusform>
            <numerusform>Βρέθηκαν %n προβλήματα. Τίποτα δεν άλλαξε. Κρατήστε αυτή τη βάση δεδομένων όπως είναι και επαναφέρετε ένα αντίγραφο ασφαλείας που περνά τον έλεγχο.</numerusform>
        </translation>
    </message>
    <message>
        <source>The check was stopped after %1 records. It had found no errors until then.</source>
        <translation>Ο έλεγχος σταμάτησε μετά από %1 εγγραφές. Ως τότε δεν βρέθηκε πρόβλημα.</translation>
    </message>
    <message>
        <source>No errors were found: %1 records, every recording, every score and the audit trail were checked.</source>
        <translation>Δεν βρέθηκε πρόβλημα: ελέγχθηκαν %1 εγγραφές, κάθε καταγραφή, κάθε βαθμολογία και το ημερολόγιο ελέγχου.</translation>
    </message>
    <message>
        <source>Automatic backups are off. Only backups that you make yourself protect what is recorded.</source>
        <translation>Τα αυτόματα αντίγραφα ασφαλείας είναι απενεργοποιημένα. Όσα καταγράφονται προστατεύονται μόνο από αντίγραφα που δημιουργείτε εσείς.</translation>
    </message>
    <message>
        <source>The first automatic backup is made when nobody has used the program for a few minutes, or when it closes.</source>
        <translation>Το πρώτο αυτόματο αντίγραφο ασφαλείας δημιουργείται όταν κανείς δεν έχει χρησιμοποιήσει το πρόγραμμα για λίγα λεπτά ή όταν το πρόγραμμα κλείνει.</translation>
    </message>
    <message>
        <source>The latest automatic backup was made and checked on %1 (%2).</source>
        <translation>Το τελευταίο αυτόματο αντίγραφο ασφαλείας δημιουργήθηκε και ελέγχθηκε στις %1 (%2).</translation>
    </message>
    <message>
        <source>The backups are on the same disk as the site: if that disk fails, both are lost. Choose a folder on another disk, on a USB drive or on the network.</source>
        <translation>Τα αντίγραφα ασφαλείας βρίσκονται στον ίδιο δίσκο με το κέντρο: αν χαλάσει ο δίσκος, χάνονται και τα δύο. Επιλέξτε φάκελο σε άλλον δίσκο, σε μονάδα USB ή στο δίκτυο.</translation>
    </message>
    <message>
        <source>An automatic backup failed %1. It will be tried again; in the meantime, make one yourself.
Details: %2</source>
        <translation>Η δημιουργία αυτόματου αντιγράφου ασφαλείας απέτυχε (%1). Θα γίνει νέα προσπάθεια· στο μεταξύ δημιουργήστε ένα εσείς.
Λεπτομέρειες: %2</translation>
    </message>
</context>
<context>
    <name>StudyControls</name>
    <message>
        <source>Move</source>
        <translation>Κίνηση</translation>
    </message>
    <message>
        <source>Move the mouse, or use the arrow keys.</source>
        <translation>Μετακινήστε το ποντίκι ή χρησιμοποιήστε τα βέλη.</translation>
    </message>
    <message>
        <source>Take the handle and move it over the objects.</source>
        <translation>Πιάστε τη λαβή και μετακινήστε την πάνω από τα αντικείμενα.</translation>
    </message>
    <message>
        <source>Take hold and pull</source>
        <translation>Πιάσιμο και έλξη</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Πίεση</translation>
    </message>
    <message>
        <source>Click, or press Enter, while the tool is at the place.</source>
        <translation>Κάντε κλικ ή πατήστε Enter όσο το εργαλείο βρίσκεται στο σημείο.</translation>
    </message>
    <message>
        <source>Press the button of the handle, or Enter, while the tip is at the place.</source>
        <translation>Πατήστε το κουμπί της λαβής ή Enter όσο η άκρη βρίσκεται στο σημείο.</translation>
    </message>
    <message>
        <source>Press 1, 2 or 3 from least to most, then Enter. Backspace takes the last one back.</source>
        <translation>Πατήστε 1, 2 ή 3 από το λιγότερο στο περισσότερο και μετά Enter. Το Backspace αναιρεί το τελευταίο.</translation>
    </message>
    <message>
        <source>Press 1 for the same, 2 for different.</source>
        <translation>Πατήστε 1 για ίδια, 2 για διαφορετικά.</translation>
    </message>
    <message>
        <source>Press Y for yes, N for no.</source>
        <translation>Πατήστε Y για ναι, N για όχι.</translation>
    </message>
    <message>
        <source>Type a number, then press Enter.</source>
        <translation>Πληκτρολογήστε έναν αριθμό και πατήστε Enter.</translation>
    </message>
    <message>
        <source>Press the number of the object: 1, 2 or 3.</source>
        <translation>Πατήστε τον αριθμό του αντικειμένου: 1, 2 ή 3.</translation>
    </message>
    <message>
        <source>Press the number of the object, or the button of the handle while you touch it.</source>
        <translation>Πατήστε τον αριθμό του αντικειμένου ή το κουμπί της λαβής όσο το αγγίζετε.</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Απάντηση</translation>
    </message>
    <message>
        <source>%1 The answers can be clicked as well.</source>
        <translation>%1 Μπορείτε επίσης να κάνετε κλικ στις απαντήσεις.</translation>
    </message>
    <message>
        <source>Press the number of the object: 1 or 2.</source>
        <translation>Πατήστε τον αριθμό του αντικειμένου: 1 ή 2.</translation>
    </message>
    <message>
        <source>Press + and − until both seem the same, then Enter.</source>
        <translation>Πατήστε + και − μέχρι να σας μοιάζουν και τα δύο ίδια, και μετά Enter.</translation>
    </message>
    <message>
        <source>Press 1, 2 or 3 from least to most, with = before one that equals the last, then Enter. Backspace takes the last one back.</source>
        <translation>Πατήστε 1, 2 ή 3 από το λιγότερο στο περισσότερο, με = πριν από ένα ίσο με το τελευταίο, και μετά Enter. Το Backspace αναιρεί το τελευταίο.</translation>
    </message>
    <message>
        <source>To let go, lower the tool %1 mm below the ring, then raise it.</source>
        <translation>Για να αφήσετε το αντικείμενο, κατεβάστε το εργαλείο %1 mm κάτω από τον δακτύλιο και μετά σηκώστε το.</translation>
    </message>
    <message>
        <source>To raise the tool, roll the wheel away from you, or hold Page Up.</source>
        <translation>Για να σηκώσετε το εργαλείο, γυρίστε τον τροχό προς τα εμπρός ή κρατήστε το Page Up.</translation>
    </message>
    <message>
        <source>Raise the handle to come off.</source>
        <translation>Σηκώστε τη λαβή για να απομακρυνθείτε από το αντικείμενο.</translation>
    </message>
    <message>
        <source>Take hold and lift</source>
        <translation>Πιάσιμο και ανύψωση</translation>
    </message>
    <message>
        <source>To lift, roll the wheel away from you, or hold Page Up.</source>
        <translation>Για ανύψωση γυρίστε τον τροχό προς τα εμπρός ή κρατήστε το Page Up.</translation>
    </message>
    <message>
        <source>To lift, raise the handle.</source>
        <translation>Για ανύψωση σηκώστε τη λαβή.</translation>
    </message>
    <message>
        <source>Put down and let go</source>
        <translation>Απόθεση και απελευθέρωση</translation>
    </message>
    <message>
        <source>To pull, roll the wheel away from you, or hold Page Up.</source>
        <translation>Για να τραβήξετε, γυρίστε τον τροχό προς τα εμπρός ή κρατήστε το Page Up.</translation>
    </message>
    <message>
        <source>To pull, raise the handle.</source>
        <translation>Για να τραβήξετε, σηκώστε τη λαβή.</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Άφημα</translation>
    </message>
    <message>
        <source>Press lightly and stroke</source>
        <translation>Ελαφριά πίεση και τρίψιμο</translation>
    </message>
    <message>
        <source>Then move the mouse, or use the arrow keys.</source>
        <translation>Ύστερα μετακινήστε το ποντίκι ή χρησιμοποιήστε τα βέλη.</translation>
    </message>
    <message>
        <source>Then move it to and fro.</source>
        <translation>Ύστερα κινήστε την πέρα δώθε.</translation>
    </message>
    <message>
        <source>Move the tool over a ring and lower it into the ring: roll the wheel towards you, or hold Page Down.</source>
        <translation>Φέρτε το εργαλείο πάνω από έναν δακτύλιο και κατεβάστε το μέσα στον δακτύλιο: γυρίστε τον τροχό προς τα πίσω ή κρατήστε το Page Down.</translation>
    </message>
    <message>
        <source>Move the tip over a ring and lower it into the ring.</source>
        <translation>Φέρτε την άκρη πάνω από έναν δακτύλιο και κατεβάστε την μέσα στον δακτύλιο.</translation>
    </message>
    <message>
        <source>Move the tool over an object and lower it onto the object: roll the wheel towards you, or hold Page Down.</source>
        <translation>Φέρτε το εργαλείο πάνω από ένα αντικείμενο και κατεβάστε το επάνω στο αντικείμενο: γυρίστε τον τροχό προς τα πίσω ή κρατήστε το Page Down.</translation>
    </message>
    <message>
        <source>Move the tip over an object and push it gently into the object.</source>
        <translation>Φέρτε την άκρη πάνω από ένα αντικείμενο και πιέστε την απαλά μέσα στο αντικείμενο.</translation>
    </message>
    <message>
        <source>To let go, lower the tool below the dashed line (roll the wheel towards you, or hold Page Down), then raise it.</source>
        <translation>Για να αφήσετε το αντικείμενο, κατεβάστε το εργαλείο κάτω από τη διακεκομμένη γραμμή (γυρίστε τον τροχό προς τα πίσω ή κρατήστε το Page Down) και μετά σηκώστε το.</translation>
    </message>
    <message>
        <source>To let go, lower the tip below the dashed line, then raise it.</source>
        <translation>Για να αφήσετε το αντικείμενο, κατεβάστε την άκρη κάτω από τη διακεκομμένη γραμμή και μετά σηκώστε την.</translation>
    </message>
    <message>
        <source>Lift it off the table: roll the wheel away from you, or hold Page Up.</source>
        <translation>Σηκώστε το από το τραπέζι: γυρίστε τον τροχό προς τα εμπρός ή κρατήστε το Page Up.</translation>
    </message>
    <message>
        <source>Lift it off the table.</source>
        <translation>Σηκώστε το από το τραπέζι.</translation>
    </message>
    <message>
        <source>You are holding the object.</source>
        <translation>Κρατάτε το αντικείμενο.</translation>
    </message>
    <message>
        <source>You are holding object %1.</source>
        <translation>Κρατάτε το αντικείμενο %1.</translation>
    </message>
    <message>
        <source>To put it down, lower it to the table: roll the wheel towards you, or hold Page Down.</source>
        <translation>Για να το αφήσετε, κατεβάστε το στο τραπέζι: γυρίστε τον τροχό προς τα πίσω ή κρατήστε το Page Down.</translation>
    </message>
    <message>
        <source>To put it down, lower it to the table.</source>
        <translation>Για να το αφήσετε, κατεβάστε το στο τραπέζι.</translation>
    </message>
    <message>
        <source>You are lifting the object.</source>
        <translation>Σηκώνετε το αντικείμενο.</translation>
    </message>
    <message>
        <source>You are lifting object %1.</source>
        <translation>Σηκώνετε το αντικείμενο %1.</translation>
    </message>
    <message>
        <source>The object stands on the table, and you still hold it.</source>
        <translation>Το αντικείμενο στέκεται στο τραπέζι και το κρατάτε ακόμη.</translation>
    </message>
    <message>
        <source>Object %1 stands on the table, and you still hold it.</source>
        <translation>Το αντικείμενο %1 στέκεται στο τραπέζι και το κρατάτε ακόμη.</translation>
    </message>
    <message>
        <source>Now raise the tool: the object stays on the table.</source>
        <translation>Τώρα σηκώστε το εργαλείο: το αντικείμενο μένει στο τραπέζι.</translation>
    </message>
    <message>
        <source>Now raise the tool: object %1 stays on the table.</source>
        <translation>Τώρα σηκώστε το εργαλείο: το αντικείμενο %1 μένει στο τραπέζι.</translation>
    </message>
    <message>
        <source>Without a wheel, hold the right mouse button or Shift and move the mouse forward to raise the tool, back to lower it. %1 T frees the pointer, so that the answers can be clicked as well; a click in the scene takes it back and does not count as an answer.</source>
        <translation>Χωρίς τροχό, κρατήστε το δεξί κουμπί του ποντικιού ή το Shift και μετακινήστε το ποντίκι εμπρός για να σηκώσετε το εργαλείο και πίσω για να το κατεβάσετε. %1 Το T ελευθερώνει τον δείκτη, ώστε να μπορείτε να κάνετε κλικ στις απαντήσεις· ένα κλικ στη σκηνή τον επαναφέρει και δεν μετράει ως απάντηση.</translation>
    </message>
    <message>
        <source>Lift the tool off.</source>
        <translation>Σηκώστε το εργαλείο.</translation>
    </message>
    <message>
        <source>Raise the tool.</source>
        <translation>Σηκώστε το εργαλείο.</translation>
    </message>
    <message>
        <source>Raise the handle.</source>
        <translation>Σηκώστε τη λαβή.</translation>
    </message>
    <message>
        <source>To put the object down, roll the wheel towards you, or hold Page Down, until the object stands on the table, and at least %1 mm further. Then raise the tool: the object stays there.</source>
        <translation>Για να αφήσετε το αντικείμενο, γυρίστε τον τροχό προς τα πίσω ή κρατήστε το Page Down, ώσπου το αντικείμενο να σταθεί στο τραπέζι και τουλάχιστον %1 mm ακόμη. Ύστερα σηκώστε το εργαλείο: το αντικείμενο μένει εκεί.</translation>
    </message>
    <message>
        <source>To put the object down, lower it onto the table and press it down with at least %1 N. Then raise the handle: the object stays there.</source>
        <translation>Για να αφήσετε το αντικείμενο, κατεβάστε το στο τραπέζι και πιέστε το με τουλάχιστον %1 N. Ύστερα σηκώστε τη λαβή: το αντικείμενο μένει εκεί.</translation>
    </message>
    <message>
        <source>To let go, lower the tool at least %1 mm further, then raise it.</source>
        <translation>Για να αφήσετε το αντικείμενο, κατεβάστε το εργαλείο τουλάχιστον %1 mm ακόμη και μετά σηκώστε το.</translation>
    </message>
    <message>
        <source>To let go, press it onto the table with at least %1 N, then raise the handle.</source>
        <translation>Για να το αφήσετε, πιέστε το στο τραπέζι με τουλάχιστον %1 N και μετά σηκώστε τη λαβή.</translation>
    </message>
</context>
<context>
    <name>StudyData</name>
    <message>
        <source>Participant and condition</source>
        <translation>Συμμετέχων και συνθήκη</translation>
    </message>
</context>
<context>
    <name>StudyDevice</name>
    <message>
        <source>The device of this station renders no force: objects are shown, not felt. Such runs are left out of groups and comparisons unless you include them under Data.</source>
        <translation>Η συσκευή αυτού του σταθμού δεν αποδίδει δύναμη: τα αντικείμενα προβάλλονται, δεν γίνονται αισθητά. Τέτοιες εκτελέσεις εξαιρούνται από ομάδες και συγκρίσεις, εκτός αν τις συμπεριλάβετε στην οθόνη «Δεδομένα».</translation>
    </message>
</context>
<context>
    <name>StudyReport</name>
    <message>
        <source>Study report</source>
        <translation>Αναφορά μελέτης</translation>
    </message>
    <message>
        <source>DEMONSTRATION: invented people and results</source>
        <translation>ΕΠΙΔΕΙΞΗ: φανταστικά πρόσωπα και αποτελέσματα</translation>
    </message>
    <message numerus="yes">
        <source>SIMULATED: %n participant(s) are programs, not people</source>
        <translation>
            <numerusform>ΠΡΟΣΟΜΟΙΩΣΗ: %n συμμετέχων είναι πρόγραμμα, όχι πρόσωπο</numerusform>
            <numerusform>ΠΡΟΣΟΜΟΙΩΣΗ: %n συμμετέχοντες είναι προγράμματα, όχι πρόσωπα</numerusform>
        </translation>
    </message>
    <message>
        <source>BLINDED: conditions carry sealed codes until the study is unblinded</source>
        <translation>ΤΥΦΛΗ: οι συνθήκες φέρουν σφραγισμένους κωδικούς έως την άρση της τυφλότητας</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Μελέτη</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Κατάσταση</translation>
    </message>
    <message>
        <source>Frozen on</source>
        <translation>Οριστικοποιήθηκε</translation>
    </message>
    <message>
        <source>Participants, planned</source>
        <translation>Συμμετέχοντες, προβλεπόμενοι</translation>
    </message>
    <message>
        <source>Scored trials</source>
        <translation>Βαθμολογημένες δοκιμές</translation>
    </message>
    <message>
        <source>Order of conditions</source>
        <translation>Σειρά των συνθηκών</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Σπόρος</translation>
    </message>
    <message>
        <source>Participants blinded</source>
        <translation>Τυφλότητα συμμετεχόντων</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ναι</translation>
    </message>
    <message>
        <source>no</source>
        <translation>όχι</translation>
    </message>
    <message>
        <source>Experimenters blinded</source>
        <translation>Τυφλότητα πειραματιστών</translation>
    </message>
    <message>
        <source>unblinded</source>
        <translation>έχει αρθεί</translation>
    </message>
    <message>
        <source>Frozen design (SHA-256)</source>
        <translation>Οριστικό σχέδιο (SHA-256)</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Συνθήκες</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Συνθήκη</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Ιδιότητα</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Αναφορά</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Έργο</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Διαδικασία</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Διαφορές</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Συμμετέχοντες</translation>
    </message>
    <message>
        <source>person</source>
        <translation>πρόσωπο</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 από %2</translation>
    </message>
    <message>
        <source>Nobody takes part yet.</source>
        <translation>Κανείς δεν συμμετέχει ακόμη.</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Κωδικός</translation>
    </message>
    <message>
        <source>Person or simulated</source>
        <translation>Πρόσωπο ή προσομοίωση</translation>
    </message>
    <message>
        <source>Enrolled</source>
        <translation>Εγγραφή</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Συγκατάθεση</translation>
    </message>
    <message>
        <source>Conditions done</source>
        <translation>Ολοκληρωμένες συνθήκες</translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation>Πιστότητα</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Βαθμολογημένες</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Επαναλήψεις</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Εξάσκηση</translation>
    </message>
    <message>
        <source>Why repeated</source>
        <translation>Λόγος επανάληψης</translation>
    </message>
    <message>
        <source>Choices reproduced</source>
        <translation>Αναπαραγωγή επιλογών</translation>
    </message>
    <message>
        <source>A trial is repeated when the force is off by more than %1 N, the felt value by more than %2, more than %3 of the ticks are late, or the device is at its limit for more than %4 of the contact.</source>
        <translation>Μια δοκιμή επαναλαμβάνεται όταν η δύναμη αποκλίνει πάνω από %1 N ή η αίσθηση πάνω από %2, όταν καθυστερεί πάνω από %3 των κύκλων ή όταν η συσκευή είναι στο όριό της σε πάνω από %4 της επαφής.</translation>
    </message>
    <message>
        <source>Choices reproduced: when run again from its log, the procedure chose the same presentations.</source>
        <translation>Αναπαραγωγή επιλογών: όταν εκτελέστηκε ξανά από το αρχείο της, η διαδικασία επέλεξε τις ίδιες παρουσιάσεις.</translation>
    </message>
    <message>
        <source>No answers</source>
        <translation>Καμία απάντηση</translation>
    </message>
    <message numerus="yes">
        <source>%n free text(s), in the exported tables</source>
        <translation>
            <numerusform>%n ελεύθερο κείμενο, στους εξαγόμενους πίνακες</numerusform>
            <numerusform>%n ελεύθερα κείμενα, στους εξαγόμενους πίνακες</numerusform>
        </translation>
    </message>
    <message>
        <source>Median %1, interquartile range %2 to %3, n = %4</source>
        <translation>Διάμεσος %1, ενδοτεταρτημοριακό εύρος %2 έως %3, n = %4</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Ερώτηση</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Απαντήσεις</translation>
    </message>
    <message>
        <source>Difference from the reference (%)</source>
        <translation>Διαφορά από την αναφορά (%)</translation>
    </message>
    <message>
        <source>Proportion correct</source>
        <translation>Ποσοστό σωστών</translation>
    </message>
    <message>
        <source>95 % band</source>
        <translation>ζώνη 95 %</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>προσαρμογή</translation>
    </message>
    <message>
        <source>criterion</source>
        <translation>κριτήριο</translation>
    </message>
    <message>
        <source>Nobody has done this condition yet.</source>
        <translation>Κανείς δεν έχει εκτελέσει ακόμη αυτή τη συνθήκη.</translation>
    </message>
    <message>
        <source>Weber fraction of the group</source>
        <translation>Κλάσμα Weber της ομάδας</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>Διάστημα 95 %</translation>
    </message>
    <message>
        <source>95 % prediction interval</source>
        <translation>Διάστημα πρόβλεψης 95 %</translation>
    </message>
    <message>
        <source>JND at the reference</source>
        <translation>JND στην αναφορά</translation>
    </message>
    <message>
        <source>Point of subjective equality</source>
        <translation>Σημείο υποκειμενικής ισότητας</translation>
    </message>
    <message>
        <source>Exponent of the power law</source>
        <translation>Εκθέτης του νόμου δύναμης</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Κλάσμα Weber (%)</translation>
    </message>
    <message>
        <source>group</source>
        <translation>ομάδα</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Κλάσμα Weber</translation>
    </message>
    <message>
        <source>JND</source>
        <translation>JND</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Εκτέλεση</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Δυσκαμψία</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Μάζα</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Παραμόρφωση</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Τραχύτητα</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Τριβή</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Ιξώδες</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Κορυφή</translation>
    </message>
    <message>
        <source>Ranking of three</source>
        <translation>Κατάταξη τριών</translation>
    </message>
    <message>
        <source>Two alternatives (2AFC)</source>
        <translation>Δύο εναλλακτικές (2AFC)</translation>
    </message>
    <message>
        <source>Three alternatives (3AFC)</source>
        <translation>Τρεις εναλλακτικές (3AFC)</translation>
    </message>
    <message>
        <source>Odd one out of three</source>
        <translation>Το διαφορετικό από τρία</translation>
    </message>
    <message>
        <source>Same or different</source>
        <translation>Ίδιο ή διαφορετικό</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Ναι ή όχι</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>Ρύθμιση</translation>
    </message>
    <message>
        <source>Magnitude estimation</source>
        <translation>Εκτίμηση μεγέθους</translation>
    </message>
    <message>
        <source>As listed</source>
        <translation>Όπως αναγράφεται</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Τυχαία</translation>
    </message>
    <message>
        <source>Latin square</source>
        <translation>Λατινικό τετράγωνο</translation>
    </message>
    <message>
        <source>Williams design</source>
        <translation>Σχέδιο Williams</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Πρόχειρο</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Οριστικοποιημένη</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Κλειστή</translation>
    </message>
    <message>
        <source>Archived</source>
        <translation>Αρχειοθετημένη</translation>
    </message>
    <message>
        <source>Consent missing</source>
        <translation>Λείπει συγκατάθεση</translation>
    </message>
    <message>
        <source>Takes part</source>
        <translation>Συμμετέχει</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>Withdrawn</source>
        <translation>Αποσύρθηκε</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ανοικτό</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Σταμάτησε</translation>
    </message>
    <message>
        <source>Force not as commanded</source>
        <translation>Η δύναμη διέφερε από τη ζητούμενη</translation>
    </message>
    <message>
        <source>Felt value off</source>
        <translation>Απόκλιση αισθητής τιμής</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Καθυστερημένοι κύκλοι</translation>
    </message>
    <message>
        <source>Device at its limit</source>
        <translation>Συσκευή στο όριό της</translation>
    </message>
    <message>
        <source>Moved too fast</source>
        <translation>Πολύ γρήγορη κίνηση</translation>
    </message>
    <message>
        <source>Pressed too hard</source>
        <translation>Πολύ δυνατή πίεση</translation>
    </message>
    <message>
        <source>Time was up</source>
        <translation>Τέλος χρόνου</translation>
    </message>
    <message>
        <source>Not all touched</source>
        <translation>Δεν αγγίχτηκαν όλα</translation>
    </message>
    <message>
        <source>Discarded by the experimenter</source>
        <translation>Ακυρώθηκε από τον πειραματιστή</translation>
    </message>
    <message>
        <source>No mark yet</source>
        <translation>Κανένα σημείο ακόμη</translation>
    </message>
    <message>
        <source>Marks around the true apex</source>
        <translation>Σημεία γύρω από την πραγματική κορυφή</translation>
    </message>
    <message>
        <source>Error in x (% of radius)</source>
        <translation>Σφάλμα στο x (% της ακτίνας)</translation>
    </message>
    <message>
        <source>Error in y (% of radius)</source>
        <translation>Σφάλμα στο y (% της ακτίνας)</translation>
    </message>
    <message>
        <source>radius R</source>
        <translation>ακτίνα R</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>μετατόπιση</translation>
    </message>
    <message>
        <source>± 1 SD per axis</source>
        <translation>± 1 SD ανά άξονα</translation>
    </message>
    <message>
        <source>Error in locating spheres</source>
        <translation>Σφάλμα στον εντοπισμό των σφαιρών</translation>
    </message>
    <message>
        <source>Absolute error (% of radius)</source>
        <translation>Απόλυτο σφάλμα (% της ακτίνας)</translation>
    </message>
    <message>
        <source>mean over both axes ± SD</source>
        <translation>μέση τιμή των δύο αξόνων ± SD</translation>
    </message>
    <message>
        <source>published: %1 %</source>
        <translation>δημοσιευμένο: %1 %</translation>
    </message>
    <message>
        <source>%1 of R</source>
        <translation>%1 του R</translation>
    </message>
    <message>
        <source>%1 mm, %2</source>
        <translation>%1 mm, %2</translation>
    </message>
    <message>
        <source>Bias in x</source>
        <translation>Μετατόπιση στο x</translation>
    </message>
    <message>
        <source>Bias in y</source>
        <translation>Μετατόπιση στο y</translation>
    </message>
    <message>
        <source>Marks, participants</source>
        <translation>Σημεία, συμμετέχοντες</translation>
    </message>
    <message>
        <source>SD in x</source>
        <translation>SD στο x</translation>
    </message>
    <message>
        <source>SD in y</source>
        <translation>SD στο y</translation>
    </message>
    <message>
        <source>Mean absolute error ± SD</source>
        <translation>Μέσο απόλυτο σφάλμα ± SD</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Σφάλμα</translation>
    </message>
    <message>
        <source>There is no mark to summarise.</source>
        <translation>Δεν υπάρχει κανένα σημείο.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) have no mark and are left out.</source>
        <translation>
            <numerusform>%n δοκιμή χωρίς σημείο παραλείπεται.</numerusform>
            <numerusform>%n δοκιμές χωρίς σημείο παραλείπονται.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With only %n participant(s), differences between people are very uncertain.</source>
        <translation>
            <numerusform>Μόνο %n συμμετέχων: οι διαφορές μεταξύ ατόμων είναι σχεδόν άγνωστες.</numerusform>
            <numerusform>Μόνο %n συμμετέχοντες: οι διαφορές μεταξύ ατόμων είναι σχεδόν άγνωστες.</numerusform>
        </translation>
    </message>
    <message>
        <source>Some participants have fewer than 10 marks.</source>
        <translation>Ορισμένοι συμμετέχοντες έχουν λιγότερα από 10 σημεία.</translation>
    </message>
    <message>
        <source>Errors in x lean to one side: the absolute error is not only scatter.</source>
        <translation>Τα σφάλματα στο x κλίνουν προς μία πλευρά: το απόλυτο σφάλμα δεν είναι μόνο διασπορά.</translation>
    </message>
    <message>
        <source>Errors in y lean to one side: the absolute error is not only scatter.</source>
        <translation>Τα σφάλματα στο y κλίνουν προς μία πλευρά: το απόλυτο σφάλμα δεν είναι μόνο διασπορά.</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) lie off the sphere.</source>
        <translation>
            <numerusform>%n σημείο βρίσκεται εκτός της σφαίρας.</numerusform>
            <numerusform>%n σημεία βρίσκονται εκτός της σφαίρας.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) were set without touching anything.</source>
        <translation>
            <numerusform>%n σημείο τέθηκε χωρίς επαφή.</numerusform>
            <numerusform>%n σημεία τέθηκαν χωρίς επαφή.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) who withdrew are left out.</source>
        <translation>
            <numerusform>%n συμμετέχων που αποσύρθηκε παραλείπεται.</numerusform>
            <numerusform>%n συμμετέχοντες που αποσύρθηκαν παραλείπονται.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n simulated participant(s) are left out: the group contains only people.</source>
        <translation>
            <numerusform>%n προσομοιωμένος συμμετέχων παραλείπεται: η ομάδα περιλαμβάνει μόνο ανθρώπους.</numerusform>
            <numerusform>%n προσομοιωμένοι συμμετέχοντες παραλείπονται: η ομάδα περιλαμβάνει μόνο ανθρώπους.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (p &lt; %2)</source>
        <translation>%1 (p &lt; %2)</translation>
    </message>
    <message>
        <source>%1 (p = %2)</source>
        <translation>%1 (p = %2)</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>αναφορά</translation>
    </message>
    <message>
        <source>D more</source>
        <translation>κατά D</translation>
    </message>
    <message>
        <source>2D more</source>
        <translation>κατά 2D</translation>
    </message>
    <message>
        <source>Not estimable</source>
        <translation>Δεν εκτιμάται</translation>
    </message>
    <message>
        <source>estimate with its 95 % interval</source>
        <translation>εκτίμηση με διάστημα 95 %</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Ομάδα</translation>
    </message>
    <message>
        <source>Rankings</source>
        <translation>Κατατάξεις</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Σωστές</translation>
    </message>
    <message>
        <source>Kendall&apos;s τ</source>
        <translation>τ του Kendall</translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation>W του Kendall</translation>
    </message>
    <message>
        <source>Page&apos;s L</source>
        <translation>L του Page</translation>
    </message>
    <message>
        <source>The worths cannot be estimated: one object was always, or never, ranked above the others.</source>
        <translation>Οι αξίες δεν εκτιμώνται: κάποιο αντικείμενο ήταν πάντα, ή ποτέ, πάνω από τα άλλα.</translation>
    </message>
    <message>
        <source>Bradley-Terry</source>
        <translation>Bradley-Terry</translation>
    </message>
    <message>
        <source>ln worth</source>
        <translation>ln αξίας</translation>
    </message>
    <message>
        <source>Plackett-Luce</source>
        <translation>Plackett-Luce</translation>
    </message>
    <message>
        <source>Thurstone</source>
        <translation>Thurstone</translation>
    </message>
    <message>
        <source>Scale (SD)</source>
        <translation>Κλίμακα (τυπική απόκλιση)</translation>
    </message>
    <message>
        <source>Worth of each object, from all rankings of the group: how much more often it was ranked above the others. The farther apart two objects are, the easier they are to tell apart. All differences D are pooled.</source>
        <translation>Αξία κάθε αντικειμένου από όλες τις κατατάξεις της ομάδας: πόσο συχνότερα ήταν πάνω από τα άλλα. Όσο πιο μακριά βρίσκονται δύο αντικείμενα, τόσο ευκολότερα ξεχωρίζουν. Όλες οι διαφορές D λαμβάνονται μαζί.</translation>
    </message>
    <message>
        <source>Sealed reason</source>
        <translation>Σφραγισμένη αιτία</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) could not be used: the difference or the answer is missing.</source>
        <translation>
            <numerusform>%n δοκιμή δεν χρησιμοποιείται: λείπει η διαφορά ή η απάντηση.</numerusform>
            <numerusform>%n δοκιμές δεν χρησιμοποιούνται: λείπει η διαφορά ή η απάντηση.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no scored trial yet, so there is no result.</source>
        <translation>Δεν υπάρχει ακόμη βαθμολογημένη δοκιμή, οπότε δεν υπάρχει αποτέλεσμα.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n trial(s): the interval is wide and depends partly on prior assumptions.</source>
        <translation>
            <numerusform>Μόνο %n δοκιμή: το διάστημα είναι ευρύ και στηρίζεται εν μέρει σε αρχικές παραδοχές.</numerusform>
            <numerusform>Μόνο %n δοκιμές: το διάστημα είναι ευρύ και στηρίζεται εν μέρει σε αρχικές παραδοχές.</numerusform>
        </translation>
    </message>
    <message>
        <source>The objects never differed, so it is not known how well they are told apart.</source>
        <translation>Τα αντικείμενα δεν διέφεραν ποτέ, οπότε δεν είναι γνωστό πόσο καλά ξεχωρίζουν.</translation>
    </message>
    <message>
        <source>Only one difference was presented: lapses of attention cannot be distinguished from a high threshold.</source>
        <translation>Παρουσιάστηκε μόνο μία διαφορά: η απροσεξία δεν ξεχωρίζει από ένα υψηλό κατώφλι.</translation>
    </message>
    <message>
        <source>A great many differences were presented; neighbouring ones were grouped.</source>
        <translation>Παρουσιάστηκαν πάρα πολλές διαφορές· οι γειτονικές ομαδοποιήθηκαν.</translation>
    </message>
    <message>
        <source>The same answer was given every time: it says nothing about what was felt.</source>
        <translation>Δόθηκε κάθε φορά η ίδια απάντηση: δεν λέει τίποτα για το τι έγινε αισθητό.</translation>
    </message>
    <message>
        <source>The answers are no better than guessing: the threshold may be above the largest difference presented.</source>
        <translation>Οι απαντήσεις δεν είναι καλύτερες από την τύχη: το κατώφλι ίσως είναι πάνω από τη μεγαλύτερη διαφορά που παρουσιάστηκε.</translation>
    </message>
    <message>
        <source>More than a tenth of the answers look like guesses even where the difference was easy.</source>
        <translation>Πάνω από το ένα δέκατο των απαντήσεων μοιάζουν τυχαίες ακόμη και όπου η διαφορά ήταν εύκολη.</translation>
    </message>
    <message>
        <source>Answers jump from guessing to always right between two neighbouring differences: what lies between is not known.</source>
        <translation>Ανάμεσα σε δύο γειτονικές διαφορές οι απαντήσεις περνούν από τυχαίες σε πάντα σωστές: το ενδιάμεσο δεν είναι γνωστό.</translation>
    </message>
    <message>
        <source>Wrong answers name one position much more often than chance would explain.</source>
        <translation>Οι λανθασμένες απαντήσεις δείχνουν μία θέση πολύ συχνότερα από όσο εξηγεί η τύχη.</translation>
    </message>
    <message>
        <source>The conditions differ in values that the analysis needs: there will be an estimate once the study is unblinded.</source>
        <translation>Οι συνθήκες διαφέρουν σε τιμές που χρειάζεται η ανάλυση: εκτίμηση υπάρχει μετά την άρση της τυφλότητας.</translation>
    </message>
    <message>
        <source>A quick simulation without rendering: the observer knew the values.</source>
        <translation>Γρήγορη προσομοίωση χωρίς απόδοση: ο παρατηρητής γνώριζε τις τιμές.</translation>
    </message>
    <message>
        <source>The answers do not tell how small the threshold is: the value shown comes from prior assumptions.</source>
        <translation>Οι απαντήσεις δεν δείχνουν πόσο μικρό είναι το κατώφλι: η τιμή προέρχεται από αρχικές παραδοχές.</translation>
    </message>
    <message>
        <source>The answers do not tell how large the threshold is: the value shown comes from prior assumptions.</source>
        <translation>Οι απαντήσεις δεν δείχνουν πόσο μεγάλο είναι το κατώφλι: η τιμή προέρχεται από αρχικές παραδοχές.</translation>
    </message>
    <message>
        <source>The lower end of the interval comes from prior assumptions, not from the answers.</source>
        <translation>Το κάτω άκρο του διαστήματος προέρχεται από αρχικές παραδοχές, όχι από τις απαντήσεις.</translation>
    </message>
    <message>
        <source>The upper end of the interval comes from prior assumptions, not from the answers.</source>
        <translation>Το πάνω άκρο του διαστήματος προέρχεται από αρχικές παραδοχές, όχι από τις απαντήσεις.</translation>
    </message>
    <message>
        <source>The curve does not describe the answers well: attention or strategy may have changed.</source>
        <translation>Η καμπύλη δεν περιγράφει καλά τις απαντήσεις: ίσως άλλαξε η προσοχή ή η στρατηγική.</translation>
    </message>
    <message>
        <source>Another curve through the same answers puts the threshold elsewhere: treat the value with caution.</source>
        <translation>Μια άλλη καμπύλη στις ίδιες απαντήσεις δίνει άλλο κατώφλι: δείτε την τιμή με επιφύλαξη.</translation>
    </message>
    <message>
        <source>Answers do not get better as the difference grows, so there is no threshold to find.</source>
        <translation>Οι απαντήσεις δεν βελτιώνονται όσο μεγαλώνει η διαφορά, οπότε δεν υπάρχει κατώφλι να βρεθεί.</translation>
    </message>
    <message>
        <source>Answers get worse as the difference grows: check that answers and differences match.</source>
        <translation>Οι απαντήσεις χειροτερεύουν όσο μεγαλώνει η διαφορά: ελέγξτε αν οι απαντήσεις αντιστοιχούν στις διαφορές.</translation>
    </message>
    <message>
        <source>The condition has no reference above zero, so no value can be given in its unit.</source>
        <translation>Η συνθήκη δεν έχει τιμή αναφοράς πάνω από το μηδέν, οπότε δεν δίνεται τιμή στη μονάδα της.</translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) are not above zero and are left out.</source>
        <translation>
            <numerusform>%n ρύθμιση δεν είναι πάνω από το μηδέν και παραλείπεται.</numerusform>
            <numerusform>%n ρυθμίσεις δεν είναι πάνω από το μηδέν και παραλείπονται.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing has been set yet, so there is no result.</source>
        <translation>Δεν έχει ρυθμιστεί ακόμη τίποτα, οπότε δεν υπάρχει αποτέλεσμα.</translation>
    </message>
    <message numerus="yes">
        <source>With only %n setting(s), the spread of the settings is very uncertain.</source>
        <translation>
            <numerusform>Μόνο %n ρύθμιση: η διασπορά τους είναι σχεδόν άγνωστη.</numerusform>
            <numerusform>Μόνο %n ρυθμίσεις: η διασπορά τους είναι σχεδόν άγνωστη.</numerusform>
        </translation>
    </message>
    <message>
        <source>All settings are the same: the step of the adjustment may be too coarse.</source>
        <translation>Όλες οι ρυθμίσεις είναι ίδιες: το βήμα της ρύθμισης ίσως είναι πολύ μεγάλο.</translation>
    </message>
    <message numerus="yes">
        <source>%n answer(s) are not numbers above zero and are left out.</source>
        <translation>
            <numerusform>%n απάντηση δεν είναι αριθμός πάνω από το μηδέν και παραλείπεται.</numerusform>
            <numerusform>%n απαντήσεις δεν είναι αριθμοί πάνω από το μηδέν και παραλείπονται.</numerusform>
        </translation>
    </message>
    <message>
        <source>No number has been given yet, so there is no result.</source>
        <translation>Δεν έχει δοθεί ακόμη αριθμός, οπότε δεν υπάρχει αποτέλεσμα.</translation>
    </message>
    <message numerus="yes">
        <source>With only %n answer(s), the result is very uncertain.</source>
        <translation>
            <numerusform>Μόνο %n απάντηση: το αποτέλεσμα είναι πολύ αβέβαιο.</numerusform>
            <numerusform>Μόνο %n απαντήσεις: το αποτέλεσμα είναι πολύ αβέβαιο.</numerusform>
        </translation>
    </message>
    <message>
        <source>Only one stimulus intensity was presented, so there is no exponent.</source>
        <translation>Παρουσιάστηκε μόνο μία ένταση, οπότε δεν υπάρχει εκθέτης.</translation>
    </message>
    <message numerus="yes">
        <source>With only %n participant(s) with an exponent, differences between people are very uncertain.</source>
        <translation>
            <numerusform>Μόνο %n συμμετέχων με εκθέτη: οι διαφορές μεταξύ ατόμων είναι σχεδόν άγνωστες.</numerusform>
            <numerusform>Μόνο %n συμμετέχοντες με εκθέτη: οι διαφορές μεταξύ ατόμων είναι σχεδόν άγνωστες.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) are left out: their answers give no value.</source>
        <translation>
            <numerusform>%n συμμετέχων παραλείπεται: οι απαντήσεις του δεν δίνουν τιμή.</numerusform>
            <numerusform>%n συμμετέχοντες παραλείπονται: οι απαντήσεις τους δεν δίνουν τιμή.</numerusform>
        </translation>
    </message>
    <message>
        <source>No participant&apos;s answers give a value.</source>
        <translation>Από κανέναν συμμετέχοντα δεν προκύπτει τιμή.</translation>
    </message>
    <message>
        <source>One participant is not a group: there is no interval.</source>
        <translation>Ένας συμμετέχων δεν είναι ομάδα: δεν υπάρχει διάστημα.</translation>
    </message>
    <message>
        <source>The sphere has no radius above zero.</source>
        <translation>Η σφαίρα δεν έχει ακτίνα πάνω από το μηδέν.</translation>
    </message>
    <message>
        <source>This condition cannot be simulated: it needs a procedure and differences.</source>
        <translation>Η συνθήκη δεν μπορεί να προσομοιωθεί: χρειάζεται διαδικασία και διαφορές.</translation>
    </message>
    <message>
        <source>The largest difference is too small for this observer.</source>
        <translation>Η μεγαλύτερη διαφορά είναι πολύ μικρή για αυτόν τον παρατηρητή.</translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 simulated run(s) gave no value.</source>
        <translation>
            <numerusform>%n από τις %1 προσομοιωμένες εκτελέσεις δεν έδωσε τιμή.</numerusform>
            <numerusform>%n από τις %1 προσομοιωμένες εκτελέσεις δεν έδωσαν τιμή.</numerusform>
        </translation>
    </message>
    <message>
        <source>Estimated from all answers together, right and wrong</source>
        <translation>Εκτίμηση από όλες μαζί τις απαντήσεις, σωστές και λανθασμένες</translation>
    </message>
    <message>
        <source>Estimated from all orders given, taken together</source>
        <translation>Εκτίμηση από όλες μαζί τις σειρές που δόθηκαν</translation>
    </message>
    <message>
        <source>Mean and spread of the settings</source>
        <translation>Μέση τιμή και διασπορά των ρυθμίσεων</translation>
    </message>
    <message>
        <source>Power law fitted to the numbers given</source>
        <translation>Νόμος δύναμης, προσαρμοσμένος στους αριθμούς που δόθηκαν</translation>
    </message>
    <message>
        <source>Errors of the marks</source>
        <translation>Σφάλματα των σημείων</translation>
    </message>
    <message>
        <source>Right: rankings with the whole order right (guessing gives 1 in 6, fewer with ties). τ: agreement with the true order (1 identical, 0 none). W: agreement among rankings (0 none, 1 complete). L: trend towards the true order. For a person, each ranking is one judgement; for the group, each person&apos;s mean ranks are one.</source>
        <translation>Σωστές: κατατάξεις με ολόκληρη τη σειρά σωστή (στην τύχη 1 στις 6, με ισοβαθμίες λιγότερες). τ: συμφωνία με την πραγματική σειρά (1 ίδια, 0 καμία). W: συμφωνία των κατατάξεων μεταξύ τους (0 καμία, 1 πλήρης). L: τάση προς την πραγματική σειρά. Για ένα άτομο κάθε κατάταξη είναι μία κρίση, για την ομάδα οι μέσες θέσεις κάθε ατόμου.</translation>
    </message>
    <message>
        <source>Bradley-Terry, ties by Davidson</source>
        <translation>Bradley-Terry, ισοβαθμίες κατά Davidson</translation>
    </message>
    <message>
        <source>Ranking of three, with ties</source>
        <translation>Κατάταξη τριών, με ισοβαθμίες</translation>
    </message>
    <message>
        <source>People differ by more than the uncertainty of each: the group&apos;s figure says little about one person.</source>
        <translation>Τα άτομα διαφέρουν περισσότερο από την αβεβαιότητα του καθενός: η τιμή της ομάδας λέει λίγα για ένα μόνο άτομο.</translation>
    </message>
    <message>
        <source>data, with the number of trials</source>
        <translation>δεδομένα, με τον αριθμό δοκιμών</translation>
    </message>
    <message>
        <source>fit: whole order right</source>
        <translation>προσαρμογή: όλη η σειρά σωστή</translation>
    </message>
    <message>
        <source>same observer: pair in right order</source>
        <translation>το ίδιο άτομο: σωστή σειρά ζεύγους</translation>
    </message>
    <message>
        <source>criterion for a pair</source>
        <translation>κριτήριο για ζεύγος</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>αισθητή</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>μόνο προβολή</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Δύναμη</translation>
    </message>
    <message>
        <source>Over all conditions together. The number of trials is shown only for those who have done every condition.</source>
        <translation>Για όλες τις συνθήκες μαζί. Ο αριθμός των δοκιμών αναφέρεται μόνο για όσους ολοκλήρωσαν όλες τις συνθήκες.</translation>
    </message>
    <message>
        <source>The result, the time and the number of trials stay sealed until the study is unblinded.</source>
        <translation>Το αποτέλεσμα, η διάρκεια και ο αριθμός των δοκιμών μένουν σφραγισμένα έως την άρση της τυφλότητας.</translation>
    </message>
    <message numerus="yes">
        <source>Shown, not felt: %n trial(s) were done on a device that renders no force.</source>
        <translation>
            <numerusform>Μόνο προβολή, χωρίς αίσθηση: %n δοκιμή έγινε σε συσκευή που δεν αποδίδει δύναμη.</numerusform>
            <numerusform>Μόνο προβολή, χωρίς αίσθηση: %n δοκιμές έγιναν σε συσκευή που δεν αποδίδει δύναμη.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) are left out of the group: objects were shown to them, not felt.</source>
        <translation>
            <numerusform>%n συμμετέχων παραλείπεται από την ομάδα: είδε μόνο τα αντικείμενα, δεν τα αισθάνθηκε.</numerusform>
            <numerusform>%n συμμετέχοντες παραλείπονται από την ομάδα: είδαν μόνο τα αντικείμενα, δεν τα αισθάνθηκαν.</numerusform>
        </translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Λόγος</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>p, adjusted</source>
        <translation>p, προσαρμοσμένο</translation>
    </message>
    <message>
        <source>p, separate thresholds</source>
        <translation>p, χωριστά κατώφλια</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 προς %2</translation>
    </message>
    <message>
        <source>Conditions compared</source>
        <translation>Σύγκριση συνθηκών</translation>
    </message>
    <message>
        <source>Conditions are compared once the study is unblinded: looking at the difference while data come in would invalidate the test.</source>
        <translation>Οι συνθήκες συγκρίνονται μετά την άρση της τυφλότητας: αν κανείς βλέπει τη διαφορά ενώ συλλέγονται τα δεδομένα, ο έλεγχος δεν ισχύει.</translation>
    </message>
    <message>
        <source>The answers narrowed the prior to %1 of its width. Near 0 % the answers decide the result; near 100 % the prior does.</source>
        <translation>Οι απαντήσεις στένεψαν την εκ των προτέρων κατανομή στο %1 του πλάτους της. Κοντά στο 0 % το αποτέλεσμα το καθορίζουν οι απαντήσεις, κοντά στο 100 % η εκ των προτέρων κατανομή.</translation>
    </message>
    <message>
        <source>Each answer decided what came next, so one person&apos;s trials are not independent: they have no interval and no p.</source>
        <translation>Κάθε απάντηση όριζε τι ακολουθούσε, άρα οι δοκιμές ενός ατόμου δεν είναι ανεξάρτητες: δεν έχουν διάστημα ούτε p.</translation>
    </message>
    <message>
        <source>95 % interval for W of the group, from its participants: %1</source>
        <translation>Διάστημα 95 % για το W της ομάδας, υπολογισμένο στους συμμετέχοντες: %1</translation>
    </message>
    <message>
        <source>How much of the result comes from the prior: near 0 % the answers decide it, near 100 % the prior does.</source>
        <translation>Πόσο από το αποτέλεσμα προέρχεται από την εκ των προτέρων κατανομή: κοντά στο 0 % το καθορίζουν οι απαντήσεις, κοντά στο 100 % η εκ των προτέρων κατανομή.</translation>
    </message>
    <message>
        <source>Prior influence</source>
        <translation>Μερίδιο της εκ των προτέρων κατανομής</translation>
    </message>
    <message>
        <source>Share of the prior: %1</source>
        <translation>Μερίδιο της εκ των προτέρων κατανομής: %1</translation>
    </message>
    <message>
        <source>Taken back</source>
        <translation>Αναιρέθηκε</translation>
    </message>
    <message>
        <source>The group value stays sealed until the study is unblinded.</source>
        <translation>Η τιμή της ομάδας μένει σφραγισμένη μέχρι να αρθεί η τυφλότητα της μελέτης.</translation>
    </message>
    <message>
        <source>There is no group value: nobody takes part.</source>
        <translation>Δεν υπάρχει τιμή ομάδας: δεν συμμετέχει κανείς.</translation>
    </message>
    <message>
        <source>The group value includes everybody who takes part.</source>
        <translation>Η τιμή της ομάδας περιλαμβάνει όλους όσοι συμμετέχουν.</translation>
    </message>
    <message>
        <source>The group value includes %1 of %2 participants.</source>
        <translation>Η τιμή της ομάδας περιλαμβάνει %1 από %2 συμμετέχοντες.</translation>
    </message>
    <message>
        <source>%1: this condition was not begun, and no run can be started any more because the study is closed.</source>
        <translation>%1: αυτή η συνθήκη δεν ξεκίνησε, και καμία εκτέλεση δεν μπορεί πια να ξεκινήσει, επειδή η μελέτη έχει κλείσει.</translation>
    </message>
    <message>
        <source>%1: this condition has not been begun. Begin it under Run.</source>
        <translation>%1: αυτή η συνθήκη δεν έχει ξεκινήσει. Ξεκινήστε την στη «Διεξαγωγή».</translation>
    </message>
    <message>
        <source>%1: no answer counts yet. Resume the run under Run.</source>
        <translation>%1: καμία απάντηση δεν μετρά ακόμη. Συνεχίστε την εκτέλεση στη «Διεξαγωγή».</translation>
    </message>
    <message>
        <source>%1: the answers give no value. The warnings of the run say why.</source>
        <translation>%1: οι απαντήσεις δεν δίνουν τιμή. Οι προειδοποιήσεις της εκτέλεσης λένε γιατί.</translation>
    </message>
    <message>
        <source>%1: objects were shown, not felt. Such runs are left out unless they are included on purpose.</source>
        <translation>%1: τα αντικείμενα προβλήθηκαν, δεν έγιναν αισθητά. Τέτοιες εκτελέσεις εξαιρούνται, εκτός αν συμπεριληφθούν σκόπιμα.</translation>
    </message>
    <message>
        <source>%1: simulated, and therefore left out of a group of people.</source>
        <translation>%1: προσομοίωση και γι&apos; αυτό εκτός μιας ομάδας ανθρώπων.</translation>
    </message>
    <message>
        <source>%1: withdrawn, and therefore left out.</source>
        <translation>%1: αποσύρθηκε και γι&apos; αυτό μένει εκτός.</translation>
    </message>
    <message>
        <source>“%1” and “%2” are not compared yet: “%3” has no group value.</source>
        <translation>Οι συνθήκες «%1» και «%2» δεν συγκρίνονται ακόμη: η «%3» δεν έχει τιμή ομάδας.</translation>
    </message>
    <message>
        <source>in the group value</source>
        <translation>στην τιμή της ομάδας</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>σφραγισμένο</translation>
    </message>
    <message>
        <source>not begun</source>
        <translation>δεν ξεκίνησε</translation>
    </message>
    <message>
        <source>no answer counts yet</source>
        <translation>καμία απάντηση δεν μετρά ακόμη</translation>
    </message>
    <message>
        <source>every answer was right</source>
        <translation>όλες οι απαντήσεις ήταν σωστές</translation>
    </message>
    <message>
        <source>the answers give no value</source>
        <translation>οι απαντήσεις δεν δίνουν τιμή</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>μόνο προβολή</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>προσομοίωση</translation>
    </message>
    <message>
        <source>withdrawn</source>
        <translation>αποσύρθηκε</translation>
    </message>
    <message>
        <source>%1 is not in this comparison (“%2”: %3; “%4”: %5).</source>
        <translation>%1: δεν περιλαμβάνεται σε αυτή τη σύγκριση («%2»: %3· «%4»: %5).</translation>
    </message>
    <message>
        <source>So far %1 of %2 planned participants are enrolled. Enrol the others on the study&apos;s page.</source>
        <translation>Μέχρι τώρα έχουν εγγραφεί %1 από τους %2 συμμετέχοντες που σχεδιάστηκαν. Εγγράψτε τους υπόλοιπους στη σελίδα της μελέτης.</translation>
    </message>
    <message>
        <source>%1: the group value includes a run that is not finished, so it may still change. Resume the run under Run.</source>
        <translation>%1: η τιμή της ομάδας περιλαμβάνει μια εκτέλεση που δεν τελείωσε, άρα μπορεί να αλλάξει. Συνεχίστε την εκτέλεση στη «Διεξαγωγή».</translation>
    </message>
    <message>
        <source>no: %1</source>
        <translation>όχι: %1</translation>
    </message>
    <message>
        <source>“!” before a value: the run has warnings. Read them before you use the value.</source>
        <translation>«!» πριν από μια τιμή: η εκτέλεση έχει προειδοποιήσεις. Διαβάστε τις πριν χρησιμοποιήσετε την τιμή.</translation>
    </message>
    <message>
        <source>! with warnings</source>
        <translation>! με προειδοποιήσεις</translation>
    </message>
    <message>
        <source>! not in the group value</source>
        <translation>! εκτός της τιμής της ομάδας</translation>
    </message>
    <message>
        <source>Answers about single conditions are shown once the study is unblinded.</source>
        <translation>Οι απαντήσεις για μεμονωμένες συνθήκες εμφανίζονται μόλις αρθεί η τυφλότητα της μελέτης.</translation>
    </message>
    <message>
        <source>About the condition %1</source>
        <translation>Για τη συνθήκη %1</translation>
    </message>
    <message>
        <source>In the group value: %1.</source>
        <translation>Στην τιμή της ομάδας: %1.</translation>
    </message>
    <message>
        <source>%1 (%2 repeated)</source>
        <translation>%1 (%2 επαναλήφθηκαν)</translation>
    </message>
    <message>
        <source>In the group, and warnings</source>
        <translation>Στην ομάδα και προειδοποιήσεις</translation>
    </message>
    <message>
        <source>“%1” and “%2” are not compared: their values cannot be set against each other.</source>
        <translation>Οι συνθήκες «%1» και «%2» δεν συγκρίνονται: οι τιμές τους δεν είναι συγκρίσιμες.</translation>
    </message>
    <message>
        <source>“%1” and “%2” are not compared yet: only %3 has a value in both, and at least two participants are needed; nor are there two groups, since nobody has a value in “%4” alone.</source>
        <translation>Οι συνθήκες «%1» και «%2» δεν συγκρίνονται ακόμη: μόνο ο κωδικός %3 έχει τιμή και στις δύο, και χρειάζονται τουλάχιστον δύο συμμετέχοντες· ούτε δύο ομάδες υπάρχουν, αφού κανείς δεν έχει τιμή μόνο στη «%4».</translation>
    </message>
    <message>
        <source>“%1” and “%2” have a ratio, but no interval and no p: each of the two groups needs at least two people, and these have %3 and %4.</source>
        <translation>Οι συνθήκες «%1» και «%2» έχουν λόγο, αλλά όχι διάστημα ούτε p: κάθε ομάδα χρειάζεται τουλάχιστον δύο άτομα, και αυτές έχουν %3 και %4.</translation>
    </message>
    <message>
        <source>%1 is not in this comparison: it compares two separate groups, and %1 has a value in both “%2” and “%3”.</source>
        <translation>%1: δεν περιλαμβάνεται σε αυτή τη σύγκριση, που γίνεται ανάμεσα σε δύο ομάδες, ενώ ο κωδικός %1 έχει τιμή και στη «%2» και στη «%3».</translation>
    </message>
    <message>
        <source>%1 in both</source>
        <translation>%1 και στις δύο</translation>
    </message>
    <message>
        <source>two groups: %1 and %2</source>
        <translation>δύο ομάδες: %1 και %2</translation>
    </message>
    <message>
        <source>Ratio of the Weber fractions; 1 means that both are alike. It comes from the people who have a value in both conditions if there are at least two of them, otherwise from two groups, each with a value in only one condition. Adjusted: for this number of comparisons (Holm).</source>
        <translation>Λόγος των κλασμάτων Weber· το 1 σημαίνει ότι είναι ίδια. Υπολογίζεται από τα άτομα που έχουν τιμή και στις δύο συνθήκες αν είναι τουλάχιστον δύο, αλλιώς από δύο ομάδες, η καθεμιά με τιμή σε μία μόνο συνθήκη. Προσαρμοσμένο: για αυτόν τον αριθμό συγκρίσεων (Holm).</translation>
    </message>
    <message>
        <source>Separate thresholds: whether one threshold for each condition describes these people&apos;s answers better than a common one. This p is given only where the same people answered in both and the differences did not depend on the answers: after adaptive runs a fitted slope is biased, and p would be too small.</source>
        <translation>Χωριστά κατώφλια: αν ένα κατώφλι για κάθε συνθήκη περιγράφει τις απαντήσεις αυτών των ατόμων καλύτερα από ένα κοινό. Αυτό το p δίνεται μόνο όπου τα ίδια άτομα απάντησαν και στις δύο και οι διαφορές δεν εξαρτώνταν από τις απαντήσεις: μετά από προσαρμοστικές εκτελέσεις η κλίση που προσαρμόζεται είναι μεροληπτική και το p θα ήταν πολύ μικρό.</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) come from a simulated observer: nothing was rendered.</source>
        <translation>
            <numerusform>%n σημείο προέρχεται από προσομοιωμένο παρατηρητή: τίποτα δεν αποδόθηκε.</numerusform>
            <numerusform>%n σημεία προέρχονται από προσομοιωμένο παρατηρητή: τίποτα δεν αποδόθηκε.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: every answer was right, so the threshold may lie far below the smallest difference presented.</source>
        <translation>%1: όλες οι απαντήσεις ήταν σωστές, άρα το κατώφλι μπορεί να είναι πολύ κάτω από τη μικρότερη διαφορά που παρουσιάστηκε.</translation>
    </message>
    <message>
        <source>%1: the answers are no better than guessing, so the threshold may lie far above the largest difference presented. Check that the task was understood.</source>
        <translation>%1: οι απαντήσεις δεν είναι καλύτερες από τυχαίες, άρα το κατώφλι μπορεί να είναι πολύ πάνω από τη μεγαλύτερη διαφορά που παρουσιάστηκε. Ελέγξτε αν έγινε κατανοητό τι ζητείται.</translation>
    </message>
    <message>
        <source>%1: the answers do not rule out a threshold far above the largest difference presented.</source>
        <translation>%1: οι απαντήσεις δεν αποκλείουν κατώφλι πολύ πάνω από τη μεγαλύτερη διαφορά που παρουσιάστηκε.</translation>
    </message>
    <message>
        <source>%1: the answers give no value, and the run cannot be resumed because the study is closed.</source>
        <translation>%1: οι απαντήσεις δεν δίνουν τιμή, και η εκτέλεση δεν μπορεί να συνεχιστεί επειδή η μελέτη έχει κλείσει.</translation>
    </message>
    <message>
        <source>%1: the answers give no value yet. The run is not finished: resume it under Run if the participant goes on.</source>
        <translation>%1: οι απαντήσεις δεν δίνουν ακόμη τιμή. Η εκτέλεση δεν ολοκληρώθηκε: συνεχίστε την στη «Διεξαγωγή», αν το άτομο συνεχίσει.</translation>
    </message>
    <message>
        <source>the answers give no value yet</source>
        <translation>οι απαντήσεις δεν δίνουν ακόμη τιμή</translation>
    </message>
    <message>
        <source>A run counts if its answers rule out two things: a threshold far below the smallest difference presented (usually a tenth of it) and one far above the largest (usually ten times it). It does not matter whether the run is finished, or which other warnings it has. “Rule out” means that with such a threshold the answers are less than 15 % as likely as with the best one. Left out, from groups and comparisons alike, are runs whose answers do not rule out both or give no value, runs with objects shown and not felt (unless you include them), participants who have withdrawn, and simulated participants where there are people.</source>
        <translation>Μια εκτέλεση μετράει αν οι απαντήσεις της αποκλείουν δύο πράγματα: ένα κατώφλι πολύ κάτω από τη μικρότερη διαφορά που παρουσιάστηκε (συνήθως το ένα δέκατό της) και ένα πολύ πάνω από τη μεγαλύτερη (συνήθως το δεκαπλάσιό της). Άλλες προειδοποιήσεις, ή το ότι η εκτέλεση δεν ολοκληρώθηκε, δεν έχουν σημασία. «Αποκλείουν» σημαίνει: με ένα τέτοιο κατώφλι η πιθανότητα των απαντήσεων είναι κάτω από το 15 % εκείνης με το καλύτερο. Εξαιρούνται, από ομάδες και συγκρίσεις εξίσου, εκτελέσεις που οι απαντήσεις τους δεν αποκλείουν και τα δύο ή δεν δίνουν τιμή, εκτελέσεις με αντικείμενα που προβλήθηκαν χωρίς να γίνουν αισθητά (εκτός αν τις συμπεριλάβετε), συμμετέχοντες που αποσύρθηκαν και προσομοιωμένοι συμμετέχοντες όπου υπάρχουν άνθρωποι.</translation>
    </message>
    <message>
        <source>no value yet</source>
        <translation>καμία τιμή ακόμη</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>καμία τιμή</translation>
    </message>
    <message>
        <source>adjusted p</source>
        <translation>προσαρμοσμένο p</translation>
    </message>
    <message>
        <source>%1 participants in both conditions</source>
        <translation>%1 συμμετέχοντες και στις δύο συνθήκες</translation>
    </message>
    <message>
        <source>two groups of %1 and %2 participants</source>
        <translation>δύο ομάδες των %1 και %2 συμμετεχόντων</translation>
    </message>
    <message>
        <source>Compared in both conditions: %1.</source>
        <translation>Συγκρίνονται και στις δύο συνθήκες: %1.</translation>
    </message>
    <message>
        <source>The values show no difference between “%1” and “%2” (ratio %3, 95 % interval: %4; %5).</source>
        <translation>Δεν φαίνεται διαφορά μεταξύ «%1» και «%2» (λόγος %3, διάστημα 95 %: %4· %5).</translation>
    </message>
    <message>
        <source>unbounded in practice (too few participants)</source>
        <translation>πρακτικά απεριόριστο (πολύ λίγοι συμμετέχοντες)</translation>
    </message>
    <message>
        <source>Every answer was right: the threshold may lie below the smallest difference presented, but how far below is not known.</source>
        <translation>Όλες οι απαντήσεις ήταν σωστές: το κατώφλι μπορεί να είναι κάτω από τη μικρότερη διαφορά που παρουσιάστηκε, αλλά δεν είναι γνωστό πόσο.</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Διακόπηκε</translation>
    </message>
    <message>
        <source>%1: the answers do not rule out a threshold far below the smallest difference presented.</source>
        <translation>%1: οι απαντήσεις δεν αποκλείουν κατώφλι πολύ κάτω από τη μικρότερη διαφορά που παρουσιάστηκε.</translation>
    </message>
    <message>
        <source>%1: the answers do not rule out a threshold far below the smallest difference presented, nor one far above the largest.</source>
        <translation>%1: οι απαντήσεις δεν αποκλείουν ούτε κατώφλι πολύ κάτω από τη μικρότερη διαφορά που παρουσιάστηκε ούτε κατώφλι πολύ πάνω από τη μεγαλύτερη.</translation>
    </message>
    <message>
        <source>The study&apos;s table has larger differences, which were not presented. To measure the threshold, copy the study and plan more trials or a larger first difference.</source>
        <translation>Ο πίνακας της μελέτης έχει μεγαλύτερες διαφορές, που δεν παρουσιάστηκαν. Για να μετρηθεί το κατώφλι, αντιγράψτε τη μελέτη και προβλέψτε περισσότερες δοκιμές ή μεγαλύτερη πρώτη διαφορά.</translation>
    </message>
    <message>
        <source>The study&apos;s table has smaller differences, which were not presented. To measure the threshold, copy the study and plan more trials.</source>
        <translation>Ο πίνακας της μελέτης έχει μικρότερες διαφορές, που δεν παρουσιάστηκαν. Για να μετρηθεί το κατώφλι, αντιγράψτε τη μελέτη και προβλέψτε περισσότερες δοκιμές.</translation>
    </message>
    <message>
        <source>To measure the threshold, copy the study and plan larger differences.</source>
        <translation>Για να μετρηθεί το κατώφλι, αντιγράψτε τη μελέτη και προβλέψτε μεγαλύτερες διαφορές.</translation>
    </message>
    <message>
        <source>To measure the threshold, copy the study and plan smaller differences.</source>
        <translation>Για να μετρηθεί το κατώφλι, αντιγράψτε τη μελέτη και προβλέψτε μικρότερες διαφορές.</translation>
    </message>
    <message>
        <source>Only one difference was presented. To measure the threshold, copy the study and plan several.</source>
        <translation>Παρουσιάστηκε μόνο μία διαφορά. Για να μετρηθεί το κατώφλι, αντιγράψτε τη μελέτη και προβλέψτε περισσότερες διαφορές.</translation>
    </message>
    <message>
        <source>the threshold may be far above the largest difference</source>
        <translation>το κατώφλι μπορεί να είναι πολύ πάνω από τη μεγαλύτερη διαφορά</translation>
    </message>
    <message>
        <source>the answers leave the threshold open</source>
        <translation>οι απαντήσεις αφήνουν το κατώφλι ανοικτό</translation>
    </message>
    <message>
        <source>With %1, even a tenfold difference remains possible.</source>
        <translation>Με %1 παραμένει δυνατή ακόμη και μια δεκαπλάσια διαφορά.</translation>
    </message>
    <message>
        <source>With %1, every ratio in this interval remains possible: it is not shown that the two are alike.</source>
        <translation>Με %1 παραμένει δυνατός κάθε λόγος μέσα σε αυτό το διάστημα: δεν αποδείχθηκε ότι οι δύο είναι ίδιες.</translation>
    </message>
    <message>
        <source>Two groups are compared: %2, with a value only in “%1”, and %4, with a value only in “%3”.</source>
        <translation>Συγκρίνονται δύο ομάδες: %2, με τιμή μόνο στη «%1», και %4, με τιμή μόνο στη «%3».</translation>
    </message>
    <message>
        <source>It is not known whether the Weber fractions of “%1” and “%2” differ: these values give no interval and no p.</source>
        <translation>Δεν είναι γνωστό αν διαφέρουν τα κλάσματα Weber των «%1» και «%2»: από αυτές τις τιμές δεν προκύπτει ούτε διάστημα ούτε p.</translation>
    </message>
    <message>
        <source>The interval is that of this comparison alone: once p is adjusted for all comparisons, the difference is not significant.</source>
        <translation>Το διάστημα αφορά μόνο αυτή τη σύγκριση: όταν το p προσαρμόζεται για όλες τις συγκρίσεις, η διαφορά δεν είναι σημαντική.</translation>
    </message>
    <message>
        <source>The Weber fraction of “%1” is %2 times that of “%3” (95 % interval: %4; %5).</source>
        <translation>Το κλάσμα Weber της «%1» είναι %2 φορές εκείνο της «%3» (διάστημα 95 %: %4· %5).</translation>
    </message>
    <message>
        <source>unbounded in practice (participants are too few, or differ too much)</source>
        <translation>πρακτικά απεριόριστο (οι συμμετέχοντες είναι πολύ λίγοι ή διαφέρουν πολύ μεταξύ τους)</translation>
    </message>
    <message>
        <source>There are too few answers to say whether they are better than guessing. More trials would show it.</source>
        <translation>Οι απαντήσεις είναι πολύ λίγες για να φανεί αν είναι καλύτερες από τυχαίες. Περισσότερες δοκιμές θα το έδειχναν.</translation>
    </message>
    <message>
        <source>%1 of %2 participants (%3)</source>
        <translation>%1 από %2 συμμετέχοντες (%3)</translation>
    </message>
    <message>
        <source>Test: paired t test on the log Weber fractions (df = %1; random effects with the Hartung–Knapp correction, which weights participants by the precision of their values).</source>
        <translation>Έλεγχος: t για εξαρτημένα δείγματα στους λογαρίθμους των κλασμάτων Weber (df = %1· τυχαίες επιδράσεις με διόρθωση Hartung–Knapp, που σταθμίζει τους συμμετέχοντες ανάλογα με την ακρίβεια των τιμών τους).</translation>
    </message>
    <message>
        <source>Test: Welch&apos;s t test on the log Weber fractions of two independent groups (random effects with the Hartung–Knapp correction in each).</source>
        <translation>Έλεγχος: t του Welch στους λογαρίθμους των κλασμάτων Weber δύο ανεξάρτητων ομάδων (τυχαίες επιδράσεις με διόρθωση Hartung–Knapp σε καθεμία).</translation>
    </message>
    <message>
        <source>“%1”: Weber fraction %2, of one participant.</source>
        <translation>«%1»: κλάσμα Weber %2, ενός συμμετέχοντος.</translation>
    </message>
    <message>
        <source>“%1”: Weber fraction %2 (95 % interval: %3), of %4 participants.</source>
        <translation>«%1»: κλάσμα Weber %2 (διάστημα 95 %: %3), από %4 συμμετέχοντες.</translation>
    </message>
    <message>
        <source>There is no group value yet: no participant&apos;s run is included so far.</source>
        <translation>Δεν υπάρχει ακόμη τιμή ομάδας: προς το παρόν δεν περιλαμβάνεται εκτέλεση κανενός συμμετέχοντα.</translation>
    </message>
    <message>
        <source>Fewer than 20 answers rarely measure a threshold.</source>
        <translation>Λιγότερες από 20 απαντήσεις σπάνια αρκούν για τη μέτρηση ενός κατωφλίου.</translation>
    </message>
    <message>
        <source>There are too few answers to measure the threshold.</source>
        <translation>Οι απαντήσεις είναι πολύ λίγες για να μετρηθεί το κατώφλι.</translation>
    </message>
    <message>
        <source>Copy the study and plan more trials: its page “Expected precision” shows how many trials most runs need to give a value.</source>
        <translation>Αντιγράψτε τη μελέτη και προβλέψτε περισσότερες δοκιμές: η σελίδα της «Αναμενόμενη ακρίβεια» δείχνει με πόσες οι περισσότερες εκτελέσεις δίνουν τιμή.</translation>
    </message>
    <message>
        <source>So few participants cannot show how many are needed: the study&apos;s page “Expected precision” shows it for the planned trials.</source>
        <translation>Από τόσο λίγους δεν προκύπτει πόσοι συμμετέχοντες χρειάζονται: το δείχνει η σελίδα «Αναμενόμενη ακρίβεια» της μελέτης για τις προβλεπόμενες δοκιμές.</translation>
    </message>
    <message>
        <source>more than %1</source>
        <translation>πάνω από %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>περίπου %1</translation>
    </message>
    <message>
        <source>If other people vary as much as these do, %1 participants in both conditions are needed to find, with 80 % power, a Weber fraction that is %2 times the other.</source>
        <translation>Αν η διασπορά των υπολοίπων είναι όπως αυτών, χρειάζονται %1 συμμετέχοντες και στις δύο συνθήκες, για να βρεθεί με ισχύ 80 % κλάσμα Weber %2 φορές το άλλο.</translation>
    </message>
    <message>
        <source>If other people vary as much as these do, %1 participants in each group are needed to find, with 80 % power, a Weber fraction that is %2 times the other.</source>
        <translation>Αν η διασπορά των υπολοίπων είναι όπως αυτών, χρειάζονται %1 συμμετέχοντες σε κάθε ομάδα, για να βρεθεί με ισχύ 80 % κλάσμα Weber %2 φορές το άλλο.</translation>
    </message>
    <message>
        <source>All participants here are simulated.</source>
        <translation>Όλοι οι συμμετέχοντες εδώ είναι προσομοιωμένοι.</translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) were simulated without rendering: the observers knew the values and felt nothing.</source>
        <translation>
            <numerusform>%n συμμετέχων προσομοιώθηκε χωρίς απόδοση: ο παρατηρητής γνώριζε τις τιμές και δεν ένιωθε τίποτα.</numerusform>
            <numerusform>%n συμμετέχοντες προσομοιώθηκαν χωρίς απόδοση: οι παρατηρητές γνώριζαν τις τιμές και δεν ένιωθαν τίποτα.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Objects were shown to %n participant(s), not felt. Such runs are included on purpose: each counts in the group if its answers give a value.</source>
        <translation>
            <numerusform>Σε %n συμμετέχοντα τα αντικείμενα προβλήθηκαν χωρίς να γίνουν αισθητά. Τέτοιες εκτελέσεις περιλαμβάνονται σκόπιμα: καθεμία μετράει στην ομάδα, αν οι απαντήσεις της δίνουν τιμή.</numerusform>
            <numerusform>Σε %n συμμετέχοντες τα αντικείμενα προβλήθηκαν χωρίς να γίνουν αισθητά. Τέτοιες εκτελέσεις περιλαμβάνονται σκόπιμα: καθεμία μετράει στην ομάδα, αν οι απαντήσεις της δίνουν τιμή.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudyTitles</name>
    <message>
        <source>copy</source>
        <translation>αντίγραφο</translation>
    </message>
</context>
<context>
    <name>StudyWords</name>
    <message>
        <source>Threshold</source>
        <translation>Κατώφλι</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Κλίση</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Μέση τιμή</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Τυπική απόκλιση</translation>
    </message>
    <message>
        <source>Lapse rate</source>
        <translation>Ποσοστό αβλεψιών</translation>
    </message>
    <message>
        <source>Guess rate</source>
        <translation>Ποσοστό τυχαίων απαντήσεων</translation>
    </message>
    <message>
        <source>limited by the device</source>
        <translation>περιορίζεται από τη συσκευή</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Δυσκαμψία</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Μάζα</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Παραμόρφωση</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Τραχύτητα</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Τριβή</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Ιξώδες</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Κορυφή</translation>
    </message>
    <message>
        <source>Ranking of three</source>
        <translation>Κατάταξη τριών</translation>
    </message>
    <message>
        <source>Two alternatives (2AFC)</source>
        <translation>Δύο εναλλακτικές (2AFC)</translation>
    </message>
    <message>
        <source>Three alternatives (3AFC)</source>
        <translation>Τρεις εναλλακτικές (3AFC)</translation>
    </message>
    <message>
        <source>Odd one out of three</source>
        <translation>Το διαφορετικό από τρία</translation>
    </message>
    <message>
        <source>Same or different</source>
        <translation>Ίδιο ή διαφορετικό</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Ναι ή όχι</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>Ρύθμιση</translation>
    </message>
    <message>
        <source>Magnitude estimation</source>
        <translation>Εκτίμηση μεγέθους</translation>
    </message>
    <message>
        <source>Which of two objects has more of the attribute?</source>
        <translation>Σε ποιο από δύο αντικείμενα είναι η ιδιότητα εντονότερη;</translation>
    </message>
    <message>
        <source>Which of three objects has more of the attribute? Two are the reference.</source>
        <translation>Σε ποιο από τρία αντικείμενα είναι η ιδιότητα εντονότερη; Τα δύο είναι η αναφορά.</translation>
    </message>
    <message>
        <source>Which of three objects is unlike the other two?</source>
        <translation>Ποιο από τρία αντικείμενα διαφέρει από τα άλλα δύο;</translation>
    </message>
    <message>
        <source>Are two objects the same or different?</source>
        <translation>Είναι δύο αντικείμενα ίδια ή διαφορετικά;</translation>
    </message>
    <message>
        <source>One object is adjusted until it feels like the other.</source>
        <translation>Ένα αντικείμενο ρυθμίζεται ώσπου να μοιάζει στην αφή με το άλλο.</translation>
    </message>
    <message>
        <source>Each object is given a number.</source>
        <translation>Κάθε αντικείμενο παίρνει έναν αριθμό.</translation>
    </message>
    <message>
        <source>heavier</source>
        <translation>βαρύτερο</translation>
    </message>
    <message>
        <source>slower to spring back</source>
        <translation>πιο αργό στην επαναφορά</translation>
    </message>
    <message>
        <source>rougher</source>
        <translation>πιο τραχύ</translation>
    </message>
    <message>
        <source>stickier</source>
        <translation>με περισσότερη τριβή</translation>
    </message>
    <message>
        <source>more viscous</source>
        <translation>πιο παχύρρευστο</translation>
    </message>
    <message>
        <source>higher</source>
        <translation>ψηλότερο</translation>
    </message>
    <message>
        <source>Put the three in order: each one %1 than the one before.</source>
        <translation>Βάλτε τα τρία σε σειρά: καθένα %1 από το προηγούμενο.</translation>
    </message>
    <message>
        <source>Which one is %1?</source>
        <translation>Ποιο είναι %1;</translation>
    </message>
    <message>
        <source>Which of the three is %1?</source>
        <translation>Ποιο από τα τρία είναι %1;</translation>
    </message>
    <message>
        <source>Which one is unlike the other two?</source>
        <translation>Ποιο διαφέρει από τα άλλα δύο;</translation>
    </message>
    <message>
        <source>Are the two the same or different?</source>
        <translation>Τα δύο είναι ίδια ή διαφορετικά;</translation>
    </message>
    <message>
        <source>Is it %1 than the reference?</source>
        <translation>Είναι %1 από την αναφορά;</translation>
    </message>
    <message>
        <source>As listed</source>
        <translation>Όπως αναγράφεται</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Τυχαία</translation>
    </message>
    <message>
        <source>Latin square</source>
        <translation>Λατινικό τετράγωνο</translation>
    </message>
    <message>
        <source>Williams design</source>
        <translation>Σχέδιο Williams</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Πρόχειρο</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Οριστικοποιημένη</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Κλειστή</translation>
    </message>
    <message>
        <source>Archived</source>
        <translation>Αρχειοθετημένη</translation>
    </message>
    <message>
        <source>Consent missing</source>
        <translation>Λείπει συγκατάθεση</translation>
    </message>
    <message>
        <source>Takes part</source>
        <translation>Συμμετέχει</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>Withdrawn</source>
        <translation>Αποσύρθηκε</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ανοικτό</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Σταμάτησε</translation>
    </message>
    <message>
        <source>Force not as commanded</source>
        <translation>Η δύναμη διέφερε από τη ζητούμενη</translation>
    </message>
    <message>
        <source>Felt value off</source>
        <translation>Απόκλιση αισθητής τιμής</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Καθυστερημένοι κύκλοι</translation>
    </message>
    <message>
        <source>Device at its limit</source>
        <translation>Συσκευή στο όριό της</translation>
    </message>
    <message>
        <source>Moved too fast</source>
        <translation>Πολύ γρήγορη κίνηση</translation>
    </message>
    <message>
        <source>Pressed too hard</source>
        <translation>Πολύ δυνατή πίεση</translation>
    </message>
    <message>
        <source>Time was up</source>
        <translation>Τέλος χρόνου</translation>
    </message>
    <message>
        <source>Not all touched</source>
        <translation>Δεν αγγίχτηκαν όλα</translation>
    </message>
    <message>
        <source>Discarded by the experimenter</source>
        <translation>Ακυρώθηκε από τον πειραματιστή</translation>
    </message>
    <message>
        <source>Text change</source>
        <translation>Αλλαγή κειμένου</translation>
    </message>
    <message>
        <source>Sealed reason</source>
        <translation>Σφραγισμένη αιτία</translation>
    </message>
    <message>
        <source>Ranking of three, with ties</source>
        <translation>Κατάταξη τριών, με ισοβαθμίες</translation>
    </message>
    <message>
        <source>Taken back</source>
        <translation>Αναιρέθηκε</translation>
    </message>
    <message>
        <source>“%1” is not a number. Separate numbers by semicolons or line ends.</source>
        <translation>Το «%1» δεν είναι αριθμός. Χωρίστε τους αριθμούς με «;» ή αλλαγές γραμμής.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Διαφορές</translation>
    </message>
    <message>
        <source>Ratios of differences</source>
        <translation>Λόγοι διαφορών</translation>
    </message>
    <message>
        <source>stiffer</source>
        <translation>πιο δύσκαμπτο</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Αναίρεση</translation>
    </message>
    <message>
        <source>Three objects that differ by equal ratios are put in order.</source>
        <translation>Τρία αντικείμενα που διαφέρουν κατά ίσους λόγους μπαίνουν σε σειρά.</translation>
    </message>
    <message>
        <source>Three objects that differ by equal ratios are put in order; those that feel the same may be marked as equal.</source>
        <translation>Τρία αντικείμενα που διαφέρουν κατά ίσους λόγους μπαίνουν σε σειρά· όσα μοιάζουν ίδια μπορούν να χαρακτηριστούν ίσα.</translation>
    </message>
    <message>
        <source>Put the three in order: each one %1 than the one before. You may mark those that seem the same as equal.</source>
        <translation>Βάλτε τα τρία σε σειρά: καθένα %1 από το προηγούμενο. Όσα σας μοιάζουν ίδια μπορούν να χαρακτηριστούν ίσα.</translation>
    </message>
    <message>
        <source>Give a number to what you perceive. Any positive number is allowed.</source>
        <translation>Δώστε έναν αριθμό σε αυτό που αντιλαμβάνεστε. Επιτρέπεται κάθε θετικός αριθμός.</translation>
    </message>
    <message>
        <source>The design has been changed since then. Undo in the study takes back one step after another.</source>
        <translation>Το σχέδιο άλλαξε στο μεταξύ. Η «Αναίρεση» στη μελέτη αναιρεί τα βήματα ένα προς ένα.</translation>
    </message>
    <message>
        <source>You have left the study since then, so this can no longer be undone.</source>
        <translation>Στο μεταξύ φύγατε από τη μελέτη, γι&apos; αυτό η αναίρεση δεν είναι πλέον δυνατή.</translation>
    </message>
    <message>
        <source>Does an object have more of the attribute than the reference? Trials present the object alone: show participants the reference before they begin.</source>
        <translation>Είναι η ιδιότητα ενός αντικειμένου εντονότερη από της αναφοράς; Οι δοκιμές παρουσιάζουν μόνο το αντικείμενο: δείξτε στους συμμετέχοντες την αναφορά πριν αρχίσουν.</translation>
    </message>
    <message>
        <source>Change object 2 until both seem the same.</source>
        <translation>Αλλάξτε το αντικείμενο 2 ώσπου τα δύο να σας μοιάζουν ίδια.</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Διακόπηκε</translation>
    </message>
    <message>
        <source>softness, hardness, compliance, elasticity, spring</source>
        <translation>μαλακότητα, σκληρότητα, ενδοτικότητα, ελαστικότητα, ελατήριο</translation>
    </message>
    <message>
        <source>weight, heaviness, lifting</source>
        <translation>βάρος, ανύψωση</translation>
    </message>
    <message>
        <source>recovery, relaxation, softness</source>
        <translation>επαναφορά, χαλάρωση, μαλακότητα</translation>
    </message>
    <message>
        <source>texture, smoothness</source>
        <translation>υφή, λειότητα</translation>
    </message>
    <message>
        <source>slipperiness, stickiness, sliding</source>
        <translation>ολισθηρότητα, κολλώδες, ολίσθηση</translation>
    </message>
    <message>
        <source>damping, resistance</source>
        <translation>απόσβεση, αντίσταση</translation>
    </message>
    <message>
        <source>localisation, position, highest point, shape</source>
        <translation>εντοπισμός, θέση, υψηλότερο σημείο, σχήμα</translation>
    </message>
    <message>
        <source>ordering, sorting</source>
        <translation>διάταξη, ταξινόμηση</translation>
    </message>
    <message>
        <source>2AFC, 2IFC, two-alternative forced choice, comparison, discrimination</source>
        <translation>2AFC, 2IFC, αναγκαστική επιλογή μεταξύ δύο, σύγκριση, διάκριση</translation>
    </message>
    <message>
        <source>3AFC, three-alternative forced choice, discrimination</source>
        <translation>3AFC, αναγκαστική επιλογή μεταξύ τριών, διάκριση</translation>
    </message>
    <message>
        <source>oddity, triangle test, discrimination</source>
        <translation>oddity, τριγωνική δοκιμή, διάκριση</translation>
    </message>
    <message>
        <source>same-different, AX, discrimination</source>
        <translation>ίδιο-διαφορετικό, AX, διάκριση</translation>
    </message>
    <message>
        <source>yes-no, single stimulus</source>
        <translation>ναι-όχι, μεμονωμένο ερέθισμα</translation>
    </message>
    <message>
        <source>matching, point of subjective equality, PSE</source>
        <translation>αντιστοίχιση, σημείο υποκειμενικής ισότητας, PSE</translation>
    </message>
    <message>
        <source>scaling, rating, power law</source>
        <translation>κλιμάκωση, εκτίμηση μεγέθους, νόμος δύναμης</translation>
    </message>
    <message>
        <source>1 condition, one condition</source>
        <translation>1 συνθήκη, μία συνθήκη</translation>
    </message>
    <message>
        <source>two conditions, comparison of conditions</source>
        <translation>δύο συνθήκες, σύγκριση συνθηκών</translation>
    </message>
    <message>
        <source>three conditions, comparison of conditions</source>
        <translation>τρεις συνθήκες, σύγκριση συνθηκών</translation>
    </message>
    <message>
        <source>%1 conditions</source>
        <translation>%1 συνθήκες</translation>
    </message>
    <message>
        <source>1 attribute, one attribute</source>
        <translation>1 ιδιότητα, μία ιδιότητα</translation>
    </message>
    <message>
        <source>two attributes, comparison of attributes</source>
        <translation>δύο ιδιότητες, σύγκριση ιδιοτήτων</translation>
    </message>
    <message>
        <source>three attributes, comparison of attributes</source>
        <translation>τρεις ιδιότητες, σύγκριση ιδιοτήτων</translation>
    </message>
    <message>
        <source>%1 attributes</source>
        <translation>%1 ιδιότητες</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>το %1 είναι %2</translation>
    </message>
    <message>
        <source>%1 is unlike the others</source>
        <translation>το %1 διαφέρει από τα άλλα</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>ίδια</translation>
    </message>
    <message>
        <source>different</source>
        <translation>διαφορετικά</translation>
    </message>
    <message>
        <source>no</source>
        <translation>όχι</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ναι</translation>
    </message>
    <message>
        <source>both are the same</source>
        <translation>και τα δύο είναι ίδια</translation>
    </message>
</context>
<context>
    <name>TextClaims</name>
    <message>
        <source>the reference is %1</source>
        <translation>η τιμή αναφοράς είναι %1</translation>
    </message>
    <message>
        <source>the criterion is not 75 %</source>
        <translation>το κριτήριο δεν είναι 75 %</translation>
    </message>
    <message>
        <source>the objects are shown</source>
        <translation>τα αντικείμενα φαίνονται</translation>
    </message>
    <message>
        <source>the objects are not shown</source>
        <translation>τα αντικείμενα δεν φαίνονται</translation>
    </message>
    <message>
        <source>the time to explore is limited</source>
        <translation>ο χρόνος εξερεύνησης είναι περιορισμένος</translation>
    </message>
    <message>
        <source>The text says “%1” (%2), but %3. Change one of them.</source>
        <translation>Το κείμενο λέει «%1» (%2), αλλά %3. Αλλάξτε ένα από τα δύο.</translation>
    </message>
    <message>
        <source>the task has a different number of objects</source>
        <translation>το έργο έχει άλλον αριθμό αντικειμένων</translation>
    </message>
    <message>
        <source>a different number of trials is set</source>
        <translation>έχει οριστεί άλλος αριθμός δοκιμών</translation>
    </message>
    <message>
        <source>a different time is set</source>
        <translation>έχει οριστεί άλλος χρόνος</translation>
    </message>
</context>
<context>
    <name>TrainingWords</name>
    <message>
        <source>Expert</source>
        <translation>Ειδικός</translation>
    </message>
    <message>
        <source>Intermediate</source>
        <translation>Μέσης εμπειρίας</translation>
    </message>
    <message>
        <source>Novice</source>
        <translation>Χωρίς εμπειρία</translation>
    </message>
    <message>
        <source>Hesitant (draws back)</source>
        <translation>Διστακτικός (οπισθοχωρεί)</translation>
    </message>
    <message>
        <source>Unsafe (presses too hard)</source>
        <translation>Μη ασφαλής (πιέζει υπερβολικά)</translation>
    </message>
    <message>
        <source>Replayed file %1: force shown, not felt</source>
        <translation>Αναπαραγωγή αρχείου %1: μόνο προβολή δύναμης</translation>
    </message>
    <message>
        <source>You are watching. Space: pause or continue. Esc: stop.</source>
        <translation>Παρακολουθείτε. Διάστημα: παύση ή συνέχεια. Esc: διακοπή.</translation>
    </message>
    <message>
        <source>Advance and withdraw: wheel, W and S, or Page Up and Page Down. Turn: mouse or arrow keys. Move sideways: the same with the right button or Shift. Roll: Q and E. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Προώθηση και απόσυρση: τροχός, W και S, ή Page Up και Page Down. Στροφή: ποντίκι ή βέλη. Πλάγια κίνηση: το ίδιο με δεξί κουμπί ή Shift. Περιστροφή στον άξονα: Q και E. Διάστημα: παύση, ελευθερώνει τον δείκτη. Esc: διακοπή δύναμης. F5: επανέναρξη.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Mark: click or Enter. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Κίνηση: ποντίκι ή βέλη. Κάτω και πάνω: τροχός, σύρσιμο με το δεξί κουμπί ή Page Down και Page Up. Σημείωση: κλικ ή Enter. Διάστημα: παύση, ελευθερώνει τον δείκτη. Esc: διακοπή δύναμης. F5: επανέναρξη.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Close the jaw: hold the left button or G. Open it: the same with Shift, or H. Instrument: 1 is the right one, 2 the left one. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Κίνηση: ποντίκι ή βέλη. Κάτω και πάνω: τροχός, σύρσιμο με το δεξί κουμπί ή Page Down και Page Up. Κλείσιμο σιαγόνων: κρατήστε το αριστερό κουμπί ή το G. Άνοιγμα: το ίδιο με Shift, ή H. Εργαλείο: το 1 είναι το δεξί, το 2 το αριστερό. Διάστημα: παύση, ελευθερώνει τον δείκτη. Esc: διακοπή δύναμης. F5: επανέναρξη.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Close the jaw: hold the left button or G. Open it: the same with Shift, or H. Instrument: 1 to 4. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Κίνηση: ποντίκι ή βέλη. Κάτω και πάνω: τροχός, σύρσιμο με το δεξί κουμπί ή Page Down και Page Up. Κλείσιμο σιαγόνων: κρατήστε το αριστερό κουμπί ή το G. Άνοιγμα: το ίδιο με Shift, ή H. Εργαλείο: 1 έως 4. Διάστημα: παύση, ελευθερώνει τον δείκτη. Esc: διακοπή δύναμης. F5: επανέναρξη.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Close the jaw: hold the left button or G. Open it: the same with Shift, or H. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Κίνηση: ποντίκι ή βέλη. Κάτω και πάνω: τροχός, σύρσιμο με το δεξί κουμπί ή Page Down και Page Up. Κλείσιμο σιαγόνων: κρατήστε το αριστερό κουμπί ή το G. Άνοιγμα: το ίδιο με Shift, ή H. Διάστημα: παύση, ελευθερώνει τον δείκτη. Esc: διακοπή δύναμης. F5: επανέναρξη.</translation>
    </message>
    <message>
        <source>You move the right instrument (1)</source>
        <translation>Κινείτε το δεξί εργαλείο (1)</translation>
    </message>
    <message>
        <source>You move the left instrument (2)</source>
        <translation>Κινείτε το αριστερό εργαλείο (2)</translation>
    </message>
    <message>
        <source>You move instrument %1 of %2</source>
        <translation>Κινείτε το εργαλείο %1 από %2</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Press and lift: wheel, right button and drag, or Page Down and Page Up. Mark a finding: click or Enter.</source>
        <translation>Κίνηση: ποντίκι ή βέλη. Πίεση και ανύψωση: τροχός, σύρσιμο με το δεξί κουμπί ή Page Down και Page Up. Σημείωση ευρήματος: κλικ ή Enter.</translation>
    </message>
    <message>
        <source>Rate the finding: 1 to 5, V for the other rating, + and − for the size.</source>
        <translation>Βαθμολόγηση ευρήματος: 1 έως 5, V για την άλλη βαθμολογία, + και − για το μέγεθος.</translation>
    </message>
    <message>
        <source>Next finding: N. Take it back: Delete. Nothing more to report: D.</source>
        <translation>Επόμενο εύρημα: N. Αφαίρεση: Delete. Τίποτε άλλο για αναφορά: D.</translation>
    </message>
    <message>
        <source>Use the mouse in the panel: T. A click in the scene brings it back.</source>
        <translation>Χρήση του ποντικιού στον διπλανό πίνακα: T. Με κλικ στη σκηνή επανέρχεται.</translation>
    </message>
    <message>
        <source>Other hand: H.</source>
        <translation>Άλλο χέρι: H.</translation>
    </message>
    <message>
        <source>Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Διάστημα: παύση, ελευθερώνει τον δείκτη. Esc: διακοπή δύναμης. F5: επανέναρξη.</translation>
    </message>
    <message>
        <source>You move the right hand (H for the left)</source>
        <translation>Κινείτε το δεξί χέρι (H για το αριστερό)</translation>
    </message>
    <message>
        <source>You move the left hand (H for the right)</source>
        <translation>Κινείτε το αριστερό χέρι (H για το δεξί)</translation>
    </message>
    <message>
        <source>Move: with the handle. Mark: button of the handle or Enter. Space: pause. Esc: stop force. F5: start again.</source>
        <translation>Κίνηση: με τη λαβή. Σημείωση: κουμπί της λαβής ή Enter. Διάστημα: παύση. Esc: διακοπή δύναμης. F5: επανέναρξη.</translation>
    </message>
    <message>
        <source>Move: with the handle. Space: pause. Esc: stop force. F5: start again.</source>
        <translation>Κίνηση: με τη λαβή. Διάστημα: παύση. Esc: διακοπή δύναμης. F5: επανέναρξη.</translation>
    </message>
    <message>
        <source>Move, press and lift: with the handle. Mark a finding: button of the handle or Enter.</source>
        <translation>Κίνηση, πίεση και ανύψωση: με τη λαβή. Σημείωση ευρήματος: κουμπί της λαβής ή Enter.</translation>
    </message>
    <message>
        <source>Squeeze tissue between the jaws: open the grip in the air, lower it, close it.</source>
        <translation>Σύσφιξη ιστού ανάμεσα στις σιαγόνες: ανοίξτε τη λαβή στον αέρα, κατεβάστε την, κλείστε την.</translation>
    </message>
    <message>
        <source>Space: pause. Esc: stop force. F5: start again.</source>
        <translation>Διάστημα: παύση. Esc: διακοπή δύναμης. F5: επανέναρξη.</translation>
    </message>
    <message>
        <source>Demonstration (%1). %2</source>
        <translation>Επίδειξη (%1). %2</translation>
    </message>
    <message>
        <source>Squeeze tissue between the jaws: open them in the air with O, lower them, close them with G. They stay as they are when you let go.</source>
        <translation>Σύσφιξη ιστού ανάμεσα στις σιαγόνες: ανοίξτε τις στον αέρα με το O, κατεβάστε τις, κλείστε τις με το G. Όταν αφήσετε το πλήκτρο, μένουν όπως είναι.</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>Completed</source>
        <translation>Ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Επιτυχία</translation>
    </message>
    <message>
        <source>Every pass mark of this level was met.</source>
        <translation>Επετεύχθησαν όλα τα όρια επιτυχίας αυτού του επιπέδου.</translation>
    </message>
    <message>
        <source>Not passed yet</source>
        <translation>Χωρίς επιτυχία ακόμη</translation>
    </message>
    <message numerus="yes">
        <source>%n pass mark(s) of this level were not met:</source>
        <translation>
            <numerusform>%n όριο επιτυχίας αυτού του επιπέδου δεν επετεύχθη:</numerusform>
            <numerusform>%n όρια επιτυχίας αυτού του επιπέδου δεν επετεύχθησαν:</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 trials were completed.</source>
        <translation>Ολοκληρώθηκαν %1 από %2 δοκιμές.</translation>
    </message>
    <message>
        <source>Stopped before the end</source>
        <translation>Σταμάτησε πριν από το τέλος</translation>
    </message>
    <message>
        <source>%1 What was recorded is kept and can be played back. The session does not count towards passing; try again when you are ready.</source>
        <translation>%1 Όσα καταγράφηκαν διατηρούνται και μπορούν να αναπαραχθούν. Η συνεδρία δεν μετράει για την επιτυχία· δοκιμάστε ξανά όταν είστε έτοιμοι.</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Διακόπηκε</translation>
    </message>
    <message>
        <source>The program ended during this session. %1 Everything recorded up to then was saved and can be played back. The session does not count towards passing.</source>
        <translation>Το πρόγραμμα τερματίστηκε κατά τη συνεδρία. %1 Όσα καταγράφηκαν ως τότε αποθηκεύτηκαν και μπορούν να αναπαραχθούν. Η συνεδρία δεν μετράει για την επιτυχία.</translation>
    </message>
    <message>
        <source>Incomplete recording</source>
        <translation>Ελλιπής καταγραφή</translation>
    </message>
    <message numerus="yes">
        <source>The computer could not keep up and %n sample(s) were lost. The rest is kept and can be played back. The session does not count towards passing; close other programs before the next attempt.</source>
        <translation>
            <numerusform>Ο υπολογιστής δεν πρόλαβε και χάθηκε %n δείγμα. Τα υπόλοιπα διατηρούνται και μπορούν να αναπαραχθούν. Η συνεδρία δεν μετράει για την επιτυχία· κλείστε άλλα προγράμματα πριν από την επόμενη προσπάθεια.</numerusform>
            <numerusform>Ο υπολογιστής δεν πρόλαβε και χάθηκαν %n δείγματα. Τα υπόλοιπα διατηρούνται και μπορούν να αναπαραχθούν. Η συνεδρία δεν μετράει για την επιτυχία· κλείστε άλλα προγράμματα πριν από την επόμενη προσπάθεια.</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended by a fault</source>
        <translation>Τερματίστηκε λόγω βλάβης</translation>
    </message>
    <message>
        <source>The device or the force supervisor stopped this session for safety. %1 What was recorded is kept. The session does not count towards passing; check the device before the next attempt.</source>
        <translation>Η συσκευή ή ο επόπτης δύναμης σταμάτησε τη συνεδρία για λόγους ασφαλείας. %1 Όσα καταγράφηκαν διατηρούνται. Η συνεδρία δεν μετράει για την επιτυχία· ελέγξτε τη συσκευή πριν από την επόμενη προσπάθεια.</translation>
    </message>
    <message>
        <source>Still running</source>
        <translation>Ακόμη σε εξέλιξη</translation>
    </message>
    <message>
        <source>This session has not ended yet. Its result will appear here when it ends.</source>
        <translation>Αυτή η συνεδρία δεν έχει τελειώσει. Το αποτέλεσμα θα εμφανιστεί εδώ μόλις τελειώσει.</translation>
    </message>
    <message>
        <source>Voided</source>
        <translation>Ακυρώθηκε</translation>
    </message>
    <message>
        <source>A trainer declared this session void. Recording and scores are kept but do not count.</source>
        <translation>Η συνεδρία ακυρώθηκε από εκπαιδευτή/-τρια. Καταγραφή και βαθμολογίες διατηρούνται, αλλά δεν μετράνε.</translation>
    </message>
    <message>
        <source>A trainer declared this session void: %1
Recording and scores are kept but do not count.</source>
        <translation>Η συνεδρία ακυρώθηκε από εκπαιδευτή/-τρια: %1
Καταγραφή και βαθμολογίες διατηρούνται, αλλά δεν μετράνε.</translation>
    </message>
    <message>
        <source>%1: no value (%2), but the pass mark is %3</source>
        <translation>%1: χωρίς τιμή (%2), ενώ το όριο επιτυχίας είναι %3</translation>
    </message>
    <message>
        <source>%1: %2, but the pass mark is %3 (%4 too much)</source>
        <translation>%1: %2, ενώ το όριο επιτυχίας είναι %3 (%4 παραπάνω)</translation>
    </message>
    <message>
        <source>%1: %2, but the pass mark is %3 (%4 too many)</source>
        <translation>%1: %2, ενώ το όριο επιτυχίας είναι %3 (%4 παραπάνω)</translation>
    </message>
    <message>
        <source>%1: %2, but the pass mark is %3 (%4 too few)</source>
        <translation>%1: %2, ενώ το όριο επιτυχίας είναι %3 (%4 λιγότερα)</translation>
    </message>
    <message>
        <source>%1: %2, but the pass mark is %3 (%4 too little)</source>
        <translation>%1: %2, ενώ το όριο επιτυχίας είναι %3 (%4 λιγότερο)</translation>
    </message>
    <message>
        <source>Familiarisation is recorded but never counts. %1</source>
        <translation>Η εξοικείωση καταγράφεται, αλλά δεν μετράει ποτέ. %1</translation>
    </message>
    <message>
        <source>The procedure was not completed.</source>
        <translation>Η διαδικασία δεν ολοκληρώθηκε.</translation>
    </message>
    <message>
        <source>%1 %2 → %3</source>
        <translation>%1 %2 → %3</translation>
    </message>
    <message>
        <source>Since your last attempt: %1</source>
        <translation>Από την προηγούμενη προσπάθειά σας: %1</translation>
    </message>
    <message>
        <source>%1 percentage points</source>
        <translation>%1 ποσοστιαίες μονάδες</translation>
    </message>
    <message>
        <source>The demonstration passed</source>
        <translation>Η επίδειξη πέτυχε</translation>
    </message>
    <message>
        <source>The demonstration was stopped</source>
        <translation>Η επίδειξη διακόπηκε</translation>
    </message>
    <message>
        <source>%1 What was recorded can be played back.</source>
        <translation>%1 Όσα καταγράφηκαν μπορούν να αναπαραχθούν.</translation>
    </message>
    <message>
        <source>This level has no pass mark. The values below are for comparison only.</source>
        <translation>Αυτό το επίπεδο δεν έχει όριο επιτυχίας. Οι παρακάτω τιμές είναι μόνο για σύγκριση.</translation>
    </message>
    <message>
        <source>Since the previous attempt: %1</source>
        <translation>Από την προηγούμενη προσπάθεια: %1</translation>
    </message>
</context>
<context>
    <name>WeightCheck</name>
    <message>
        <source>Largest force</source>
        <translation>Μέγιστη δύναμη</translation>
    </message>
    <message>
        <source>The heaviest object weighs %1 N. From %2 N on, which is 80 % of the largest force of a trial, participants are told to pull less hard, so merely holding this object would give it away. Allow at least %3 N, or choose lighter objects.</source>
        <translation>Το βαρύτερο αντικείμενο ζυγίζει %1 N. Από %2 N και πάνω, δηλαδή το 80 % της μέγιστης δύναμης μιας δοκιμής, οι συμμετέχοντες διαβάζουν να τραβούν λιγότερο δυνατά· και μόνο το κράτημα αυτού του αντικειμένου θα το πρόδιδε. Επιτρέψτε τουλάχιστον %3 N ή επιλέξτε ελαφρύτερα αντικείμενα.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AccountScreen</name>
    <message>
        <source>Reading your account …</source>
        <translation>Ανάγνωση του λογαριασμού σας …</translation>
    </message>
    <message>
        <source>My account</source>
        <translation>Ο λογαριασμός μου</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Όνομα</translation>
    </message>
    <message>
        <source>Full name (may be left empty)</source>
        <translation>Πλήρες όνομα (προαιρετικό)</translation>
    </message>
    <message>
        <source>Save the name</source>
        <translation>Αποθήκευση ονόματος</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Γλώσσα</translation>
    </message>
    <message>
        <source>As on this station</source>
        <translation>Όπως σε αυτόν τον σταθμό</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Κωδικός πρόσβασης</translation>
    </message>
    <message>
        <source>Current password</source>
        <translation>Τωρινός κωδικός πρόσβασης</translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation>Αλλαγή κωδικού</translation>
    </message>
    <message>
        <source>Change my password</source>
        <translation>Αλλαγή του κωδικού μου</translation>
    </message>
    <message>
        <source>Your account could not be read.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση του λογαριασμού σας.</translation>
    </message>
    <message>
        <source>Login name: %1. An administrator can change it.</source>
        <translation>Όνομα χρήστη: %1. Μπορεί να το αλλάξει ένας διαχειριστής.</translation>
    </message>
    <message>
        <source>The full name is too long: use at most %1 characters.</source>
        <translation>Το πλήρες όνομα είναι πολύ μεγάλο: χρησιμοποιήστε το πολύ %1 χαρακτήρες.</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Αποθήκευση …</translation>
    </message>
    <message>
        <source>Your name is now %1.</source>
        <translation>Το όνομά σας είναι πλέον %1.</translation>
    </message>
    <message>
        <source>Your name was not changed.
%1</source>
        <translation>Το όνομά σας δεν άλλαξε.
%1</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Έλεγχος …</translation>
    </message>
    <message>
        <source>This is the password that you have now. Choose another one.</source>
        <translation>Αυτός είναι ο τωρινός σας κωδικός. Επιλέξτε άλλον.</translation>
    </message>
    <message>
        <source>Your password has been changed. From your next login, only the new one is valid.</source>
        <translation>Ο κωδικός πρόσβασής σας άλλαξε. Από την επόμενη σύνδεση ισχύει μόνο ο νέος.</translation>
    </message>
    <message>
        <source>The current password is wrong. Nothing was changed. Passwords are case-sensitive; check Caps Lock.</source>
        <translation>Ο τωρινός κωδικός είναι λάθος. Δεν άλλαξε τίποτα. Τα κεφαλαία διαφέρουν από τα πεζά· ελέγξτε το Caps Lock.</translation>
    </message>
    <message>
        <source>The password was not changed.
%1</source>
        <translation>Ο κωδικός πρόσβασης δεν άλλαξε.
%1</translation>
    </message>
    <message>
        <source>Login name: %1. You can change it under People.</source>
        <translation>Όνομα χρήστη: %1. Μπορείτε να το αλλάξετε στην οθόνη «Άτομα».</translation>
    </message>
    <message>
        <source>Recovery code</source>
        <translation>Κωδικός ανάκτησης</translation>
    </message>
    <message>
        <source>With a recovery code you can set a new password yourself if you forget yours: at the login, choose &quot;Forgot your password?&quot;.</source>
        <translation>Με έναν κωδικό ανάκτησης ορίζετε μόνοι σας νέο κωδικό πρόσβασης αν ξεχάσετε τον δικό σας: στη σύνδεση επιλέξτε «Ξεχάσατε τον κωδικό;».</translation>
    </message>
    <message>
        <source>Make a recovery code …</source>
        <translation>Δημιουργία κωδικού ανάκτησης …</translation>
    </message>
    <message>
        <source>The program could not read whether you have a recovery code.
%1</source>
        <translation>Δεν ήταν δυνατό να διαβαστεί αν έχετε κωδικό ανάκτησης.
%1</translation>
    </message>
    <message>
        <source>You have one. If it is lost or somebody else may have seen it, make a new one; it replaces the present one.</source>
        <translation>Έχετε κωδικό ανάκτησης. Αν χάθηκε ή αν ίσως τον είδε κάποιος άλλος, δημιουργήστε νέο· αντικαθιστά τον τωρινό.</translation>
    </message>
    <message>
        <source>You have none yet. Without it, only another administrator can help you if you forget your password.</source>
        <translation>Δεν έχετε ακόμη κωδικό ανάκτησης. Χωρίς αυτόν, αν ξεχάσετε τον κωδικό πρόσβασης, μπορεί να σας βοηθήσει μόνο άλλος διαχειριστής.</translation>
    </message>
    <message>
        <source>Your own name, language and password.

The full name is what others see in lists and reports; your earlier names stay in the site&apos;s history. The login name can be changed by an administrator.

The language takes effect at once. It is used whenever you log in on this station, and changes nothing for others.

To change your password, first enter the one that you have now.

Administrators can make a recovery code for themselves here; with it they can set a new password if they forget theirs.</source>
        <translation>Το όνομά σας, η γλώσσα και ο κωδικός πρόσβασής σας.

Το πλήρες όνομα το βλέπουν οι άλλοι σε λίστες και αναφορές· τα προηγούμενα ονόματά σας μένουν στο ιστορικό του κέντρου. Το όνομα χρήστη μπορεί να το αλλάξει ένας διαχειριστής.

Η γλώσσα ισχύει αμέσως. Ισχύει κάθε φορά που συνδέεστε σε αυτόν τον σταθμό και δεν αλλάζει τίποτα για τους άλλους.

Για να αλλάξετε τον κωδικό πρόσβασης, γράψτε πρώτα τον τωρινό.

Οι διαχειριστές μπορούν να δημιουργήσουν εδώ τον δικό τους κωδικό ανάκτησης· με αυτόν ορίζουν νέο κωδικό πρόσβασης αν ξεχάσουν τον δικό τους.</translation>
    </message>
    <message>
        <source>It is used whenever you log in on this station, and changes nothing for others.</source>
        <translation>Ισχύει κάθε φορά που συνδέεστε σε αυτόν τον σταθμό και δεν αλλάζει τίποτα για τους άλλους.</translation>
    </message>
    <message>
        <source>Others now see only your login name.</source>
        <translation>Οι άλλοι βλέπουν πλέον μόνο το όνομα χρήστη σας.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AddPersonDialog</name>
    <message>
        <source>Add a person</source>
        <translation>Προσθήκη ατόμου</translation>
    </message>
    <message>
        <source>Full name (may be left empty)</source>
        <translation>Πλήρες όνομα (προαιρετικό)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Προσθήκη</translation>
    </message>
    <message>
        <source>%1 was not added: somebody has this name already. Names that differ only in capital letters count as the same.</source>
        <translation>Δεν προστέθηκε: %1. Αυτό το όνομα υπάρχει ήδη. Ονόματα που διαφέρουν μόνο σε κεφαλαία και πεζά θεωρούνται ίδια.</translation>
    </message>
    <message>
        <source>%1 was not added.
%2</source>
        <translation>Δεν προστέθηκε: %1.
%2</translation>
    </message>
    <message>
        <source>%1 was added.</source>
        <translation>Προστέθηκε: %1.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AdministratorPage</name>
    <message>
        <source>Who looks after this site?</source>
        <translation>Ποιος διαχειρίζεται αυτό το κέντρο;</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Όνομα χρήστη</translation>
    </message>
    <message>
        <source>Full name (may be left empty)</source>
        <translation>Πλήρες όνομα (προαιρετικό)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Πίσω</translation>
    </message>
    <message>
        <source>Set up the site</source>
        <translation>Δημιουργία κέντρου</translation>
    </message>
    <message>
        <source>This name cannot be used. Use at most %1 characters, no commas and no spaces at the ends. Some names are reserved for the program.</source>
        <translation>Αυτό το όνομα δεν επιτρέπεται. Χρησιμοποιήστε το πολύ %1 χαρακτήρες, χωρίς κόμματα και χωρίς κενά στα άκρα. Ορισμένα ονόματα είναι δεσμευμένα από το πρόγραμμα.</translation>
    </message>
    <message>
        <source>Creating the site …</source>
        <translation>Δημιουργία του κέντρου …</translation>
    </message>
    <message>
        <source>A short name without commas, such as &quot;ada&quot;.</source>
        <translation>Ένα σύντομο όνομα χωρίς κόμματα, π.χ. «eleni».</translation>
    </message>
    <message>
        <source>Name of the site, such as the clinic&apos;s (may be left empty)</source>
        <translation>Όνομα του κέντρου, π.χ. της κλινικής (προαιρετικό)</translation>
    </message>
    <message>
        <source>Shown at the login, on password slips and on reports. Administrators can change it in the settings.</source>
        <translation>Εμφανίζεται στη σύνδεση, στα σημειώματα κωδικών και στις αναφορές. Οι διαχειριστές μπορούν να το αλλάξουν στις ρυθμίσεις.</translation>
    </message>
    <message>
        <source>The first person is an administrator, who adds people, makes backups, and may also train, design studies and run them.</source>
        <translation>Το πρώτο άτομο είναι διαχειριστής: προσθέτει άτομα, δημιουργεί αντίγραφα ασφαλείας και μπορεί και να εκπαιδεύεται, να σχεδιάζει μελέτες και να τις διεξάγει.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AnswerPanel</name>
    <message>
        <source>here</source>
        <translation>εδώ</translation>
    </message>
    <message>
        <source>Same (1)</source>
        <translation>Ίδια (1)</translation>
    </message>
    <message>
        <source>Different (2)</source>
        <translation>Διαφορετικά (2)</translation>
    </message>
    <message>
        <source>No (N)</source>
        <translation>Όχι (N)</translation>
    </message>
    <message>
        <source>Yes (Y)</source>
        <translation>Ναι (Y)</translation>
    </message>
    <message>
        <source>Less (−)</source>
        <translation>Λιγότερο (−)</translation>
    </message>
    <message>
        <source>More (+)</source>
        <translation>Περισσότερο (+)</translation>
    </message>
    <message>
        <source>They are the same (Enter)</source>
        <translation>Είναι ίδια (Enter)</translation>
    </message>
    <message>
        <source>Your number</source>
        <translation>Ο αριθμός σας</translation>
    </message>
    <message>
        <source>Submit (Enter)</source>
        <translation>Καταχώριση (Enter)</translation>
    </message>
    <message>
        <source>Back (⌫)</source>
        <translation>Πίσω (⌫)</translation>
    </message>
    <message>
        <source>Confirm (Enter)</source>
        <translation>Επιβεβαίωση (Enter)</translation>
    </message>
    <message>
        <source>least</source>
        <translation>το λιγότερο</translation>
    </message>
    <message>
        <source>between</source>
        <translation>ανάμεσα</translation>
    </message>
    <message>
        <source>most</source>
        <translation>το περισσότερο</translation>
    </message>
    <message>
        <source>Enter a number above zero.</source>
        <translation>Πληκτρολογήστε αριθμό μεγαλύτερο από το μηδέν.</translation>
    </message>
    <message>
        <source>Equal to the last (=)</source>
        <translation>Ίσο με το τελευταίο (=)</translation>
    </message>
    <message>
        <source>the left one</source>
        <translation>το αριστερό</translation>
    </message>
    <message>
        <source>the right one</source>
        <translation>το δεξί</translation>
    </message>
    <message>
        <source>the middle one</source>
        <translation>το μεσαίο</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ApexPage</name>
    <message>
        <source>Nobody has done this condition yet. Each participant&apos;s marks will appear here after the first run.</source>
        <translation>Κανείς δεν έχει εκτελέσει ακόμη αυτή τη συνθήκη. Τα σημεία κάθε συμμετέχοντα θα εμφανιστούν εδώ μετά την πρώτη εκτέλεση.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Ομάδα</translation>
    </message>
    <message>
        <source>%1 mm (%2)</source>
        <translation>%1 mm (%2)</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>SD %1</source>
        <translation>SD %1</translation>
    </message>
    <message>
        <source>Bias in %1</source>
        <translation>Μετατόπιση στο %1</translation>
    </message>
    <message>
        <source>Mean absolute error</source>
        <translation>Μέσο απόλυτο σφάλμα</translation>
    </message>
    <message>
        <source>SD %1; published: %2</source>
        <translation>SD %1· δημοσιευμένο: %2</translation>
    </message>
    <message numerus="yes">
        <source>Per cent of the sphere&apos;s radius. %n mark(s)</source>
        <translation>
            <numerusform>Επί τοις εκατό της ακτίνας της σφαίρας. %n σημείο</numerusform>
            <numerusform>Επί τοις εκατό της ακτίνας της σφαίρας. %n σημεία</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n trial(s) repeated</source>
        <translation>
            <numerusform>, %n δοκιμή επαναλήφθηκε</numerusform>
            <numerusform>, %n δοκιμές επαναλήφθηκαν</numerusform>
        </translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Εκτελέσεις</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Κωδικός</translation>
    </message>
    <message>
        <source>Bias in x</source>
        <translation>Μετατόπιση στο x</translation>
    </message>
    <message>
        <source>Bias in y</source>
        <translation>Μετατόπιση στο y</translation>
    </message>
    <message>
        <source>SD in x</source>
        <translation>SD στο x</translation>
    </message>
    <message>
        <source>SD in y</source>
        <translation>SD στο y</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Δοκιμές</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Εκτέλεση</translation>
    </message>
    <message>
        <source>%1 (%2 repeated)</source>
        <translation>%1 (%2 επαναλήφθηκαν)</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Mean error</source>
        <translation>Μέσο σφάλμα</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ApexStage</name>
    <message>
        <source>Scene</source>
        <translation>Σκηνή</translation>
    </message>
    <message>
        <source>Where is the highest point?</source>
        <translation>Πού είναι το ψηλότερο σημείο;</translation>
    </message>
    <message>
        <source>Here it is (Enter)</source>
        <translation>Εδώ είναι (Enter)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AttemptsTable</name>
    <message>
        <source>My attempts</source>
        <translation>Οι προσπάθειές μου</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Πότε</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Δύναμη</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Τιμή</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Αποτέλεσμα</translation>
    </message>
    <message>
        <source>Level %1, familiarisation</source>
        <translation>Επίπεδο %1, εξοικείωση</translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation>Επίπεδο %1</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Προσπάθεια</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AutomaticCard</name>
    <message>
        <source>Automatic backups</source>
        <translation>Αυτόματα αντίγραφα ασφαλείας</translation>
    </message>
    <message>
        <source>Once a day, when nobody has used the program for a few minutes, or when it closes. A session or a study is never disturbed. Each backup is checked after it is made.</source>
        <translation>Μία φορά την ημέρα, όταν κανείς δεν έχει χρησιμοποιήσει το πρόγραμμα για λίγα λεπτά ή όταν το πρόγραμμα κλείνει. Καμία συνεδρία ή μελέτη δεν διακόπτεται. Κάθε αντίγραφο ελέγχεται μετά τη δημιουργία του.</translation>
    </message>
    <message>
        <source>Make a backup every day</source>
        <translation>Δημιουργία αντιγράφου ασφαλείας κάθε μέρα</translation>
    </message>
    <message>
        <source>Automatic backups to keep</source>
        <translation>Αυτόματα αντίγραφα που διατηρούνται</translation>
    </message>
    <message>
        <source>Older ones are removed. Backups that you made yourself are never removed.</source>
        <translation>Τα παλαιότερα αφαιρούνται. Τα αντίγραφα που δημιουργήσατε εσείς δεν αφαιρούνται ποτέ.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::BackupKeeper</name>
    <message>
        <source>Open storage</source>
        <translation>Άνοιγμα φύλαξης δεδομένων</translation>
    </message>
    <message>
        <source>The automatic backup was not made; it will be tried again.
%1</source>
        <translation>Το αυτόματο αντίγραφο ασφαλείας δεν δημιουργήθηκε· θα γίνει νέα προσπάθεια.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::BreakPanel</name>
    <message>
        <source>Break time</source>
        <translation>Χρόνος διαλείμματος</translation>
    </message>
    <message>
        <source>Enter or Space: read on</source>
        <translation>Enter ή Διάστημα: συνέχεια ανάγνωσης</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::CheckList</name>
    <message>
        <source>good</source>
        <translation>εντάξει</translation>
    </message>
    <message>
        <source>worth a look</source>
        <translation>χρειάζεται προσοχή</translation>
    </message>
    <message>
        <source>must be corrected</source>
        <translation>πρέπει να διορθωθεί</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Εμφάνιση</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>Εμφάνιση: %1</translation>
    </message>
    <message>
        <source>being calculated</source>
        <translation>υπολογίζεται</translation>
    </message>
    <message>
        <source>What is checked before freezing</source>
        <translation>Τι ελέγχεται πριν από την οριστικοποίηση</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::CheckPage</name>
    <message>
        <source>Before you freeze</source>
        <translation>Πριν από την οριστικοποίηση</translation>
    </message>
    <message>
        <source>Pilot runs</source>
        <translation>Πιλοτικές δοκιμές</translation>
    </message>
    <message>
        <source>Somebody tries the design as it is now, with the real trials on this station. A pilot is kept apart: it is never analysed or exported with the study&apos;s data.</source>
        <translation>Κάποιος δοκιμάζει το σχέδιο όπως είναι τώρα, με τις πραγματικές δοκιμές σε αυτόν τον σταθμό. Η πιλοτική δοκιμή φυλάσσεται χωριστά: ποτέ δεν αναλύεται ή εξάγεται μαζί με τα δεδομένα της μελέτης.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) that count</source>
        <translation>
            <numerusform>%n δοκιμή που μετρά</numerusform>
            <numerusform>%n δοκιμές που μετρούν</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n repeated</source>
        <translation>
            <numerusform>%n επανάληψη</numerusform>
            <numerusform>%n επαναλήψεις</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s per trial</source>
        <translation>%1 s ανά δοκιμή</translation>
    </message>
    <message>
        <source>Pilot run …</source>
        <translation>Πιλοτική δοκιμή …</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Οριστικοποίηση</translation>
    </message>
    <message>
        <source>Freezing is final: nobody can change the design afterwards, and every result can be traced to it. Participants can be enrolled from then on. To change something later, copy the study into a new one.</source>
        <translation>Η οριστικοποίηση είναι τελική: κατόπιν κανείς δεν μπορεί να αλλάξει το σχέδιο και κάθε αποτέλεσμα ανάγεται σε αυτό. Από τότε μπορούν να εγγραφούν συμμετέχοντες. Για να αλλάξετε κάτι αργότερα, αντιγράψτε τη μελέτη σε νέα.</translation>
    </message>
    <message>
        <source>Freeze …</source>
        <translation>Οριστικοποίηση …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ChoiceTile</name>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Εύρεση εντολής</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Εντολή</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Εντολές που βρέθηκαν</translation>
    </message>
    <message>
        <source>%1   (%2)</source>
        <translation>%1   (%2)</translation>
    </message>
    <message>
        <source>Type what you want to do, or a name</source>
        <translation>Γράψτε τι θέλετε να κάνετε ή ένα όνομα</translation>
    </message>
    <message>
        <source>Nothing matches. Try fewer letters or another word.</source>
        <translation>Δεν βρέθηκε τίποτα. Δοκιμάστε λιγότερα γράμματα ή άλλη λέξη.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Εντολές</translation>
    </message>
    <message>
        <source>Further commands</source>
        <translation>Άλλες εντολές</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::CommentPanel</name>
    <message>
        <source>Comments</source>
        <translation>Σχόλια</translation>
    </message>
    <message>
        <source>No comments yet.</source>
        <translation>Δεν υπάρχουν ακόμη σχόλια.</translation>
    </message>
    <message>
        <source>New comment</source>
        <translation>Νέο σχόλιο</translation>
    </message>
    <message>
        <source>What do you see here?</source>
        <translation>Τι βλέπετε εδώ;</translation>
    </message>
    <message>
        <source>You</source>
        <translation>Εσείς</translation>
    </message>
    <message>
        <source>Somebody else</source>
        <translation>Άλλο άτομο</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message>
        <source>Whole session · %1 · %2</source>
        <translation>Όλη η συνεδρία · %1 · %2</translation>
    </message>
    <message>
        <source>(erased)</source>
        <translation>(διαγράφηκε)</translation>
    </message>
    <message>
        <source>Reviewed, nothing to add</source>
        <translation>Αξιολογήθηκε, χωρίς προσθήκη</translation>
    </message>
    <message>
        <source>Reviewed. Nothing to add.</source>
        <translation>Αξιολογήθηκε. Δεν υπάρχει τίποτα να προστεθεί.</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Απάντηση</translation>
    </message>
    <message>
        <source>Do not reply</source>
        <translation>Χωρίς απάντηση</translation>
    </message>
    <message>
        <source>Reply to %1</source>
        <translation>Απάντηση προς: %1</translation>
    </message>
    <message>
        <source>Comment here: %1</source>
        <translation>Σχόλιο εδώ: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::CommentsScreen</name>
    <message>
        <source>Comments</source>
        <translation>Σχόλια</translation>
    </message>
    <message>
        <source>All comments that you received or wrote, unread ones first, then the newest.

Each leads to its moment in the playback, or to the debrief where it is about the whole session. What is shown here counts as read.</source>
        <translation>Όλα τα σχόλια που λάβατε ή γράψατε, πρώτα τα αδιάβαστα, μετά τα νεότερα.

Καθένα οδηγεί στη στιγμή του στην αναπαραγωγή, ή στον απολογισμό όταν αφορά όλη τη συνεδρία. Ό,τι εμφανίζεται εδώ θεωρείται διαβασμένο.</translation>
    </message>
    <message>
        <source>Reading the comments …</source>
        <translation>Ανάγνωση των σχολίων …</translation>
    </message>
    <message>
        <source>The comments could not be read.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση των σχολίων.</translation>
    </message>
    <message>
        <source>No comments yet</source>
        <translation>Δεν υπάρχουν ακόμη σχόλια</translation>
    </message>
    <message>
        <source>Comments on your sessions, and your comments on other people&apos;s sessions, will appear here.</source>
        <translation>Ό,τι γράφεται για τις συνεδρίες σας, και ό,τι γράφετε για τις συνεδρίες άλλων, θα βρίσκεται εδώ.</translation>
    </message>
    <message>
        <source>Which comments</source>
        <translation>Ποια σχόλια</translation>
    </message>
    <message>
        <source>Received and written</source>
        <translation>Όσα λάβατε και όσα γράψατε</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Ληφθέντα</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Γραμμένα</translation>
    </message>
    <message>
        <source>Show older comments</source>
        <translation>Εμφάνιση παλαιότερων σχολίων</translation>
    </message>
    <message>
        <source>Nobody has commented on your sessions yet.</source>
        <translation>Κανείς δεν έχει σχολιάσει ακόμη τις συνεδρίες σας.</translation>
    </message>
    <message>
        <source>You have not written any yet.</source>
        <translation>Δεν έχετε γράψει ακόμη κανένα.</translation>
    </message>
    <message>
        <source>You</source>
        <translation>Εσείς</translation>
    </message>
    <message>
        <source>Somebody else</source>
        <translation>Κάποιος άλλος</translation>
    </message>
    <message>
        <source>%1 on your session %2: %3 · %4</source>
        <translation>%1 για τη συνεδρία σας %2: %3 · %4</translation>
    </message>
    <message>
        <source>%1 on session %2 of %3: %4 · %5</source>
        <translation>%1 για τη συνεδρία %2 (%3): %4 · %5</translation>
    </message>
    <message>
        <source>Unread</source>
        <translation>Αδιάβαστο</translation>
    </message>
    <message>
        <source>(erased)</source>
        <translation>(διαγράφηκε)</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Παρακολούθηση</translation>
    </message>
    <message>
        <source>Open the debrief</source>
        <translation>Άνοιγμα απολογισμού</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ComparisonPage</name>
    <message>
        <source>Conditions compared</source>
        <translation>Σύγκριση συνθηκών</translation>
    </message>
    <message>
        <source>This study has only one condition, so there is nothing to compare it with.</source>
        <translation>Αυτή η μελέτη έχει μόνο μία συνθήκη, οπότε δεν υπάρχει κάτι με το οποίο να συγκριθεί.</translation>
    </message>
    <message>
        <source>Weber fractions are compared. The search for an apex has none: its groups tell errors in millimetres.</source>
        <translation>Συγκρίνονται κλάσματα Weber. Η αναζήτηση μιας κορυφής δεν έχει: οι ομάδες της δείχνουν σφάλματα σε χιλιοστά.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ConditionQuestions</name>
    <message>
        <source>Please answer about the part that you have just finished, and about nothing else.</source>
        <translation>Απαντήστε για το μέρος που μόλις ολοκληρώσατε και για τίποτε άλλο.</translation>
    </message>
    <message>
        <source>Submit</source>
        <translation>Υποβολή</translation>
    </message>
    <message>
        <source>The answers were not stored. They are still on this page: press Submit again, and call the experimenter if that does not help.
%1</source>
        <translation>Οι απαντήσεις δεν αποθηκεύτηκαν. Βρίσκονται ακόμη σε αυτή τη σελίδα: πατήστε ξανά «Υποβολή» και καλέστε τον πειραματιστή αν αυτό δεν βοηθήσει.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ConditionsPage</name>
    <message>
        <source>Remove</source>
        <translation>Αφαίρεση</translation>
    </message>
    <message>
        <source>Add a condition</source>
        <translation>Προσθήκη συνθήκης</translation>
    </message>
    <message>
        <source>Remove a condition</source>
        <translation>Αφαίρεση συνθήκης</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Τι συγκρίνεται</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Τίτλος</translation>
    </message>
    <message>
        <source>Id of a condition</source>
        <translation>Αναγνωριστικό συνθήκης</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Ιδιότητα</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Αναφορά</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Έργο</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Κριτήριο</translation>
    </message>
    <message>
        <source>Table of differences</source>
        <translation>Πίνακας διαφορών</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Διαδικασία</translation>
    </message>
    <message>
        <source>Several procedures are interleaved at random.</source>
        <translation>Οι διαδικασίες εναλλάσσονται τυχαία.</translation>
    </message>
    <message>
        <source>Scale of the procedure</source>
        <translation>Κλίμακα της διαδικασίας</translation>
    </message>
    <message>
        <source>Remove a procedure</source>
        <translation>Αφαίρεση διαδικασίας</translation>
    </message>
    <message>
        <source>Add a procedure</source>
        <translation>Προσθήκη διαδικασίας</translation>
    </message>
    <message>
        <source>Sealed conditions</source>
        <translation>Σφραγισμένες συνθήκες</translation>
    </message>
    <message>
        <source>The study is blind: until it is unblinded, its conditions are shown only by these codes and their differences are hidden. Only the study&apos;s author and administrators see the design.</source>
        <translation>Η μελέτη είναι τυφλή: έως την άρση της τυφλότητας οι συνθήκες εμφανίζονται μόνο με αυτούς τους κωδικούς και οι διαφορές τους αποκρύπτονται. Τον σχεδιασμό βλέπουν μόνο ο συντάκτης του και οι διαχειριστές.</translation>
    </message>
    <message>
        <source>What the conditions have in common</source>
        <translation>Τι έχουν κοινό οι συνθήκες</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Υποψήφιες διαφορές</translation>
    </message>
    <message>
        <source>Differences from the reference</source>
        <translation>Διαφορές από την αναφορά</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 έως %2</translation>
    </message>
    <message>
        <source>The procedure works on</source>
        <translation>Η διαδικασία δουλεύει με</translation>
    </message>
    <message>
        <source>What is looked for</source>
        <translation>Τι αναζητείται</translation>
    </message>
    <message>
        <source>What the condition is called in tables and figures. Participants never see it.</source>
        <translation>Πώς ονομάζεται η συνθήκη σε πίνακες και γραφήματα. Οι συμμετέχοντες δεν το βλέπουν ποτέ.</translation>
    </message>
    <message>
        <source>Short name in exports</source>
        <translation>Σύντομο όνομα στις εξαγωγές</translation>
    </message>
    <message>
        <source>Radius of the sphere</source>
        <translation>Ακτίνα της σφαίρας</translation>
    </message>
    <message>
        <source>How large the sphere is whose highest point is looked for.</source>
        <translation>Πόσο μεγάλη είναι η σφαίρα της οποίας αναζητείται το ψηλότερο σημείο.</translation>
    </message>
    <message>
        <source>The object that the others are compared with.</source>
        <translation>Το αντικείμενο με το οποίο συγκρίνονται τα άλλα.</translation>
    </message>
    <message>
        <source>Threshold at</source>
        <translation>Κατώφλι στο</translation>
    </message>
    <message>
        <source>The differences from the reference that a procedure may choose from.</source>
        <translation>Οι διαφορές από την αναφορά από τις οποίες μπορεί να επιλέξει μια διαδικασία.</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Δοκιμές</translation>
    </message>
    <message>
        <source>Ratios suit thresholds: from 2 % to 4 % is as far as from 10 % to 20 %. Differences suit tables on both sides of the reference.</source>
        <translation>Οι λόγοι ταιριάζουν σε κατώφλια: από 2 % έως 4 % η απόσταση είναι όση από 10 % έως 20 %. Οι διαφορές ταιριάζουν σε πίνακες και στις δύο πλευρές της αναφοράς.</translation>
    </message>
    <message>
        <source>What is different for the participant</source>
        <translation>Τι διαφέρει για τον συμμετέχοντα</translation>
    </message>
    <message>
        <source>What participants read before this condition</source>
        <translation>Κείμενο πριν από αυτή τη συνθήκη</translation>
    </message>
    <message>
        <source>What the settings do not say, such as &quot;Put on the glove.&quot; or &quot;Use your other hand.&quot; Leave it empty if nothing is different. Whoever reads it can tell this condition from the others.</source>
        <translation>Ό,τι δεν λένε οι ρυθμίσεις, για παράδειγμα «Φορέστε το γάντι.» ή «Χρησιμοποιήστε το άλλο χέρι.» Αφήστε το κενό αν δεν αλλάζει τίποτα. Όποιος διαβάζει το κείμενο μπορεί να ξεχωρίσει αυτή τη συνθήκη από τις άλλες.</translation>
    </message>
    <message>
        <source>The condition “%1” was removed.</source>
        <translation>Η συνθήκη «%1» αφαιρέθηκε.</translation>
    </message>
    <message>
        <source>The last procedure of this condition was removed.</source>
        <translation>Η τελευταία διαδικασία αυτής της συνθήκης αφαιρέθηκε.</translation>
    </message>
    <message>
        <source>Change of the attribute</source>
        <translation>Αλλαγή της ιδιότητας</translation>
    </message>
    <message>
        <source>The only property in which the objects differ.</source>
        <translation>Η μόνη ιδιότητα στην οποία διαφέρουν τα αντικείμενα.</translation>
    </message>
    <message>
        <source>Lower-case letters, digits and _ only; each condition needs a different one. It follows the English title until somebody types a name.</source>
        <translation>Μόνο πεζά λατινικά γράμματα, ψηφία και _· κάθε συνθήκη έχει διαφορετικό. Ακολουθεί τον αγγλικό τίτλο, ώσπου να πληκτρολογηθεί άλλο.</translation>
    </message>
    <message>
        <source>Change of the task</source>
        <translation>Αλλαγή του έργου</translation>
    </message>
    <message>
        <source>The threshold is the difference at which this share of the answers is right.</source>
        <translation>Το κατώφλι είναι η διαφορά στην οποία αυτό το ποσοστό των απαντήσεων είναι σωστό.</translation>
    </message>
    <message>
        <source>Interleave another procedure</source>
        <translation>Προσθήκη διαδικασίας εναλλάξ</translation>
    </message>
    <message>
        <source>Remove the last procedure</source>
        <translation>Αφαίρεση της τελευταίας διαδικασίας</translation>
    </message>
    <message>
        <source>Together they have at most %1 trials.</source>
        <translation>Μαζί έχουν το πολύ %1 δοκιμές.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ConsentDialog</name>
    <message>
        <source>Consent of %1</source>
        <translation>Συγκατάθεση: %1</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Γλώσσα</translation>
    </message>
    <message>
        <source>I have read this and I agree</source>
        <translation>Το διάβασα και συμφωνώ</translation>
    </message>
    <message>
        <source>Record the consent</source>
        <translation>Καταγραφή</translation>
    </message>
    <message>
        <source>This study has no consent text.</source>
        <translation>Η μελέτη δεν έχει κείμενο συγκατάθεσης.</translation>
    </message>
    <message>
        <source>The consent was not recorded.
%1</source>
        <translation>Η συγκατάθεση δεν καταγράφηκε.
%1</translation>
    </message>
    <message>
        <source>The consent of %1 was recorded.</source>
        <translation>Η συγκατάθεση καταγράφηκε: %1.</translation>
    </message>
    <message>
        <source>Instructions</source>
        <translation>Οδηγίες</translation>
    </message>
    <message>
        <source>The time is recorded, and a checksum (SHA-256) that shows which text you have read. You may withdraw at any time.</source>
        <translation>Καταγράφονται η ώρα και ένα άθροισμα ελέγχου (SHA-256) που δείχνει ποιο κείμενο διαβάσατε. Μπορείτε να αποσυρθείτε οποτεδήποτε.</translation>
    </message>
    <message>
        <source>Once the participant agrees, tick the box first.</source>
        <translation>Τσεκάρετε πρώτα το πλαίσιο, όταν συμφωνήσει το άτομο που συμμετέχει.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ControlBar</name>
    <message>
        <source>Stop force (Esc)</source>
        <translation>Διακοπή δύναμης (Esc)</translation>
    </message>
    <message>
        <source>Resume here</source>
        <translation>Συνέχεια εδώ</translation>
    </message>
    <message>
        <source>End session …</source>
        <translation>Τέλος συνεδρίας …</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Παύση (Διάστημα)</translation>
    </message>
    <message>
        <source>Resume (Space)</source>
        <translation>Συνέχεια (Διάστημα)</translation>
    </message>
    <message>
        <source>Re-arm (R)</source>
        <translation>Ενεργοποίηση (R)</translation>
    </message>
    <message>
        <source>Start again …</source>
        <translation>Επανέναρξη …</translation>
    </message>
    <message>
        <source>Start again from the beginning (F5). The attempt so far is kept and marked as stopped.</source>
        <translation>Επανέναρξη από την αρχή (F5). Η προσπάθεια ως τώρα διατηρείται με την ένδειξη «Σταμάτησε».</translation>
    </message>
    <message>
        <source>End the practice</source>
        <translation>Τέλος εξάσκησης</translation>
    </message>
    <message>
        <source>Go on to the trials that count. Their card is shown first.</source>
        <translation>Συνεχίστε στις δοκιμές που μετράνε. Πρώτα εμφανίζονται οι οδηγίες.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::DebriefScreen</name>
    <message>
        <source>%1, level %2: %3</source>
        <translation>%1, επίπεδο %2: %3</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 · %4</source>
        <translation>%1 · %2 · %3 · %4</translation>
    </message>
    <message>
        <source>Force was shown, not felt: these scores form a separate series and are not compared with scores from felt force.</source>
        <translation>Η δύναμη προβαλλόταν, δεν γινόταν αισθητή: αυτές οι βαθμολογίες αποτελούν ξεχωριστή σειρά και δεν συγκρίνονται με εκείνες της αισθητής δύναμης.</translation>
    </message>
    <message>
        <source>Next level</source>
        <translation>Επόμενο επίπεδο</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Νέα προσπάθεια</translation>
    </message>
    <message>
        <source>Watch the worst moment</source>
        <translation>Δείτε τη χειρότερη στιγμή</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Αναπαραγωγή</translation>
    </message>
    <message>
        <source>Report (PDF)</source>
        <translation>Αναφορά (PDF)</translation>
    </message>
    <message>
        <source>Debrief</source>
        <translation>Απολογισμός</translation>
    </message>
    <message>
        <source>Open the playback</source>
        <translation>Άνοιγμα αναπαραγωγής</translation>
    </message>
    <message>
        <source>Write the report (PDF)</source>
        <translation>Δημιουργία αναφοράς (PDF)</translation>
    </message>
    <message>
        <source>Reading the scores …</source>
        <translation>Ανάγνωση βαθμολογιών …</translation>
    </message>
    <message>
        <source>This session could not be opened</source>
        <translation>Αυτή η συνεδρία δεν ήταν δυνατό να ανοίξει</translation>
    </message>
    <message>
        <source>All metrics</source>
        <translation>Όλες οι μετρήσεις</translation>
    </message>
    <message>
        <source>The recording was erased</source>
        <translation>Η καταγραφή διαγράφηκε</translation>
    </message>
    <message>
        <source>It was erased at the person&apos;s request. The scores above are kept; there is nothing to play back.</source>
        <translation>Διαγράφηκε κατόπιν αιτήματος του ατόμου. Οι βαθμολογίες παραπάνω διατηρούνται· δεν υπάρχει τίποτα για αναπαραγωγή.</translation>
    </message>
    <message>
        <source>Reading the recording …</source>
        <translation>Ανάγνωση της καταγραφής …</translation>
    </message>
    <message>
        <source>The recording could not be read. The scores above are as they were stored.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση της καταγραφής. Οι βαθμολογίες παραπάνω είναι όπως αποθηκεύτηκαν.</translation>
    </message>
    <message>
        <source>No trial was finished</source>
        <translation>Δεν ολοκληρώθηκε καμία δοκιμή</translation>
    </message>
    <message>
        <source>Chiron session %1.pdf</source>
        <translation>Chiron συνεδρία %1.pdf</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Δημιουργία αναφοράς</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Έγγραφα PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Writing the report …</source>
        <translation>Δημιουργία της αναφοράς …</translation>
    </message>
    <message>
        <source>The report was written to %1.</source>
        <translation>Η αναφορά αποθηκεύτηκε στο %1.</translation>
    </message>
    <message>
        <source>The report could not be written.</source>
        <translation>Δεν ήταν δυνατή η αποθήκευση της αναφοράς.</translation>
    </message>
    <message>
        <source>Findings and maps could not be read from the recording. The scores above are as they were stored.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση ευρημάτων και χαρτών από την καταγραφή. Οι βαθμολογίες παραπάνω είναι όπως αποθηκεύτηκαν.</translation>
    </message>
    <message>
        <source>Force of the tissue, and what was felt</source>
        <translation>Δύναμη του ιστού και τι έγινε αισθητό</translation>
    </message>
    <message>
        <source>The session was not completed: these values are not compared with pass marks.</source>
        <translation>Η συνεδρία δεν ολοκληρώθηκε: αυτές οι τιμές δεν συγκρίνονται με όρια επιτυχίας.</translation>
    </message>
    <message>
        <source>No trial was completed: there is no score.</source>
        <translation>Δεν ολοκληρώθηκε καμία δοκιμή: δεν υπάρχει βαθμολογία.</translation>
    </message>
    <message>
        <source>Now you</source>
        <translation>Τώρα εσείς</translation>
    </message>
    <message>
        <source>Watch an expert</source>
        <translation>Δείτε έναν ειδικό</translation>
    </message>
    <message>
        <source>Worst moment: %1</source>
        <translation>Χειρότερη στιγμή: %1</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Σχόλια</translation>
    </message>
    <message>
        <source>You</source>
        <translation>Εσείς</translation>
    </message>
    <message>
        <source>Somebody else</source>
        <translation>Κάποιος άλλος</translation>
    </message>
    <message>
        <source>(erased)</source>
        <translation>(διαγράφηκε)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Προβολή</translation>
    </message>
    <message>
        <source>Looking for the worst moment …</source>
        <translation>Αναζήτηση της χειρότερης στιγμής …</translation>
    </message>
    <message>
        <source>The result of this session.

At the top: whether it passed, and if not, which pass mark was missed and by how much. Below, the most important numbers on their scale: the pointer is the value, the line the pass mark, the band what others reached.

&quot;Watch the worst moment&quot; opens the playback where it went wrong most. &quot;Report&quot; writes a printable PDF. The table holds every metric with what it means.</source>
        <translation>Το αποτέλεσμα αυτής της συνεδρίας.

Πάνω: αν υπήρξε επιτυχία και, αν όχι, ποιο όριο επιτυχίας δεν επετεύχθη και κατά πόσο. Από κάτω, οι σημαντικότεροι αριθμοί στην κλίμακά τους: ο δείκτης είναι η τιμή, η γραμμή το όριο επιτυχίας, η ζώνη όσα πέτυχαν άλλοι.

Το «Δείτε τη χειρότερη στιγμή» ανοίγει την αναπαραγωγή εκεί όπου έγινε το μεγαλύτερο λάθος. Η «Αναφορά» δημιουργεί ένα εκτυπώσιμο PDF. Ο πίνακας έχει όλες τις μετρήσεις και τι σημαίνει η καθεμία.</translation>
    </message>
    <message>
        <source>No moment stands out.</source>
        <translation>Καμία στιγμή δεν ξεχωρίζει.</translation>
    </message>
    <message>
        <source>%1 in trial %2, %3 after it began</source>
        <translation>%1 στη δοκιμή %2, %3 μετά την έναρξή της</translation>
    </message>
    <message>
        <source>%1, %2 after the start</source>
        <translation>%1, %2 μετά την έναρξη</translation>
    </message>
    <message>
        <source>%1 (%2 in the recording)</source>
        <translation>%1 (%2 στην καταγραφή)</translation>
    </message>
    <message>
        <source>%1, attempt %2 at level %3: %4</source>
        <translation>%1, προσπάθεια %2 στο επίπεδο %3: %4</translation>
    </message>
    <message>
        <source>What was decided about this session</source>
        <translation>Τι αποφασίστηκε για αυτή τη συνεδρία</translation>
    </message>
    <message>
        <source>somebody whose account is closed</source>
        <translation>κάποιον με κλειστό λογαριασμό</translation>
    </message>
    <message>
        <source>Voided on %1 by %2: %3</source>
        <translation>Ακυρώθηκε στις %1 από %2: %3</translation>
    </message>
    <message>
        <source>Set to count again on %1 by %2: %3</source>
        <translation>Μετράει ξανά από τις %1, με απόφαση από %2: %3</translation>
    </message>
    <message>
        <source>Start a session that counts</source>
        <translation>Έναρξη συνεδρίας που μετράει</translation>
    </message>
    <message>
        <source>%1 · %2: %3</source>
        <translation>%1 · %2: %3</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Απάντηση</translation>
    </message>
    <message>
        <source>Practise it on level %1</source>
        <translation>Εξάσκηση στο επίπεδο %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::DeviceChooser</name>
    <message>
        <source>Ready. Force is shown, not felt.</source>
        <translation>Έτοιμα. Η δύναμη προβάλλεται, δεν γίνεται αισθητή.</translation>
    </message>
    <message>
        <source>Demonstrate</source>
        <translation>Επίδειξη</translation>
    </message>
    <message>
        <source>Replay a file</source>
        <translation>Αναπαραγωγή αρχείου</translation>
    </message>
    <message>
        <source>A recorded movement (CSV) moves the tool.</source>
        <translation>Μια καταγεγραμμένη κίνηση (CSV) κινεί το εργαλείο.</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Χειριστής</translation>
    </message>
    <message>
        <source>The session is listed as simulated and does not count for anyone.</source>
        <translation>Η συνεδρία καταχωρίζεται ως προσομοιωμένη και δεν μετράει για κανέναν.</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Επιλογή αρχείου …</translation>
    </message>
    <message>
        <source>No file is chosen yet.</source>
        <translation>Δεν έχει επιλεγεί αρχείο.</translation>
    </message>
    <message>
        <source>Choose a recorded movement</source>
        <translation>Επιλογή καταγεγραμμένης κίνησης</translation>
    </message>
    <message>
        <source>Traces (*.csv)</source>
        <translation>Καταγραφές κίνησης (*.csv)</translation>
    </message>
    <message>
        <source>Reading the file …</source>
        <translation>Ανάγνωση του αρχείου …</translation>
    </message>
    <message numerus="yes">
        <source>Ready: %n rows, %1 s.</source>
        <translation>
            <numerusform>Έτοιμο: %n γραμμή, %1 s.</numerusform>
            <numerusform>Έτοιμο: %n γραμμές, %1 s.</numerusform>
        </translation>
    </message>
    <message>
        <source>This file cannot be played. Correct it or choose another.
%1</source>
        <translation>Αυτό το αρχείο δεν μπορεί να αναπαραχθεί. Διορθώστε το ή επιλέξτε άλλο.
%1</translation>
    </message>
    <message>
        <source>There is no demonstration of this exercise on this station.</source>
        <translation>Δεν υπάρχει επίδειξη αυτής της άσκησης σε αυτόν τον σταθμό.</translation>
    </message>
    <message>
        <source>A recorded movement (CSV, with orientation) moves the endoscope.</source>
        <translation>Μια καταγεγραμμένη κίνηση (CSV, με προσανατολισμό) κινεί το ενδοσκόπιο.</translation>
    </message>
    <message>
        <source>A recorded movement (CSV, with the jaw) moves the instruments.</source>
        <translation>Μια καταγεγραμμένη κίνηση (CSV, με τις σιαγόνες) κινεί τα εργαλεία.</translation>
    </message>
    <message>
        <source>Ready. Watch a scripted operator. Device: %1.</source>
        <translation>Έτοιμη. Δείτε εικονικό χειριστή. Συσκευή: %1.</translation>
    </message>
    <message>
        <source>%1, serial number %2</source>
        <translation>%1, αριθμός σειράς %2</translation>
    </message>
    <message numerus="yes">
        <source>Ready. Force is felt. %n device(s) connected.</source>
        <translation>
            <numerusform>Έτοιμη. Η δύναμη γίνεται αισθητή. %n συνδεδεμένη συσκευή.</numerusform>
            <numerusform>Έτοιμη. Η δύναμη γίνεται αισθητή. %n συνδεδεμένες συσκευές.</numerusform>
        </translation>
    </message>
    <message>
        <source>This level takes %1 devices. Connect %2 more, then open this screen again.</source>
        <translation>Αυτό το επίπεδο χρειάζεται %1 συσκευές. Συνδέστε %2 ακόμη και ανοίξτε ξανά αυτή την οθόνη.</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Συσκευή</translation>
    </message>
    <message>
        <source>Choose a different device for each instrument.</source>
        <translation>Επιλέξτε διαφορετική συσκευή για κάθε εργαλείο.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::DifferenceTable</name>
    <message>
        <source>Smallest</source>
        <translation>Μικρότερη</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Μεγαλύτερη</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Πλήθος</translation>
    </message>
    <message>
        <source>On both sides of the reference</source>
        <translation>Και από τις δύο πλευρές της αναφοράς</translation>
    </message>
    <message>
        <source>No candidates yet.</source>
        <translation>Καμία υποψήφια διαφορά ακόμη.</translation>
    </message>
    <message>
        <source>%1 candidates, from %2 to %3 of the reference: %4 to %5.</source>
        <translation>%1 υποψήφιες, από %2 έως %3 της αναφοράς: %4 έως %5.</translation>
    </message>
    <message>
        <source>Too small for anybody to feel.</source>
        <translation>Τόσο μικρή που δεν την αισθάνεται κανείς.</translation>
    </message>
    <message>
        <source>Large enough for everybody to feel.</source>
        <translation>Τόσο μεγάλη που την αισθάνονται όλοι.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Διαφορές</translation>
    </message>
    <message>
        <source>Change them one by one, or paste them from a table; numbers may have decimal points or commas.</source>
        <translation>Αλλάξτε τις μία μία ή επικολλήστε τις από πίνακα· οι αριθμοί μπορούν να έχουν τελεία ή υποδιαστολή με κόμμα.</translation>
    </message>
    <message>
        <source>%1 % less than the reference would be below zero.</source>
        <translation>%1 % λιγότερο από την αναφορά θα ήταν κάτω από το μηδέν.</translation>
    </message>
    <message>
        <source>How many differences there are to choose from. Each object is larger than the one before by the same factor.</source>
        <translation>Πόσες διαφορές υπάρχουν προς επιλογή. Κάθε αντικείμενο είναι μεγαλύτερο από το προηγούμενο κατά τον ίδιο συντελεστή.</translation>
    </message>
    <message>
        <source>How many differences there are to choose from. They are spaced geometrically: each is larger than the one before by about the same factor.</source>
        <translation>Πόσες διαφορές υπάρχουν προς επιλογή. Κατανέμονται γεωμετρικά: καθεμία είναι μεγαλύτερη από την προηγούμενη κατά τον ίδιο περίπου συντελεστή.</translation>
    </message>
    <message>
        <source>The smallest difference has to be below the largest. The table was not changed.</source>
        <translation>Η μικρότερη διαφορά πρέπει να είναι κάτω από τη μεγαλύτερη. Ο πίνακας δεν άλλαξε.</translation>
    </message>
    <message>
        <source>Objects whose attribute is weaker than the reference&apos;s are presented as well.</source>
        <translation>Παρουσιάζονται και αντικείμενα στα οποία η ιδιότητα είναι λιγότερο έντονη από της αναφοράς.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::EditPersonDialog</name>
    <message>
        <source>Edit %1</source>
        <translation>Επεξεργασία: %1</translation>
    </message>
    <message>
        <source>Full name (may be left empty)</source>
        <translation>Πλήρες όνομα (προαιρετικό)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Αποθήκευση</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
        <translation>Αποθηκεύτηκε: %1.</translation>
    </message>
    <message>
        <source>%1 was not changed.
%2</source>
        <translation>Δεν άλλαξε: %1.
%2</translation>
    </message>
    <message>
        <source>Sessions recorded so far stay with this person and show the new name. The earlier names stay in the site&apos;s history. The password remains valid.</source>
        <translation>Οι συνεδρίες που έχουν καταγραφεί μένουν σε αυτό το άτομο και δείχνουν το νέο όνομα. Τα προηγούμενα ονόματα μένουν στο ιστορικό του κέντρου. Ο κωδικός πρόσβασης ισχύει και μετά.</translation>
    </message>
    <message>
        <source>From now on, only %1 can be used to log in.</source>
        <translation>Από εδώ και πέρα η σύνδεση γίνεται μόνο με το όνομα %1.</translation>
    </message>
    <message>
        <source>A password slip that was handed out still shows the old login name.</source>
        <translation>Ένα σημείωμα κωδικού που έχει ήδη δοθεί δείχνει ακόμη το παλιό όνομα χρήστη.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::EnrolDialog</name>
    <message>
        <source>Enrol a participant</source>
        <translation>Εγγραφή συμμετέχοντα</translation>
    </message>
    <message>
        <source>%1 of %2 planned participants are enrolled.</source>
        <translation>Έχουν εγγραφεί %1 από τους %2 που προβλέπονται.</translation>
    </message>
    <message>
        <source>Identity (name, number in your own list …)</source>
        <translation>Ταυτότητα (όνομα, αριθμός στη λίστα σας …)</translation>
    </message>
    <message>
        <source>This is kept only in the key table, which only the study&apos;s author and administrators can open. Data and exports carry the code.</source>
        <translation>Βρίσκεται μόνο στον πίνακα κλειδιών, τον οποίο ανοίγουν μόνο ο συντάκτης της μελέτης και οι διαχειριστές. Τα δεδομένα και οι εξαγωγές φέρουν τον κωδικό.</translation>
    </message>
    <message>
        <source>Enrol</source>
        <translation>Εγγραφή</translation>
    </message>
    <message>
        <source>The participant was not enrolled.
%1</source>
        <translation>Ο συμμετέχων δεν εγγράφηκε.
%1</translation>
    </message>
    <message>
        <source>The participant&apos;s code is</source>
        <translation>Ο κωδικός του συμμετέχοντα είναι</translation>
    </message>
    <message>
        <source>Write it down for the participant, who needs it at every session. Consent comes next.</source>
        <translation>Γράψτε τον για τον συμμετέχοντα: τον χρειάζεται σε κάθε συνεδρία. Ακολουθεί η συγκατάθεση.</translation>
    </message>
    <message>
        <source>Record the consent now</source>
        <translation>Καταγραφή της συγκατάθεσης τώρα</translation>
    </message>
    <message>
        <source>Login name, if the participant has an account here (optional)</source>
        <translation>Όνομα χρήστη, αν ο συμμετέχων έχει λογαριασμό εδώ (προαιρετικό)</translation>
    </message>
    <message>
        <source>With the login name, an export or erasure of this person&apos;s data also covers what they do in this study. The name is kept only in the key table; no list and no export of the study shows it.</source>
        <translation>Με το όνομα χρήστη, μια εξαγωγή ή διαγραφή των δεδομένων αυτού του ατόμου περιλαμβάνει και όσα κάνει σε αυτή τη μελέτη. Φυλάσσεται μόνο στον πίνακα κλειδιών· δεν το δείχνει καμία λίστα και καμία εξαγωγή της μελέτης.</translation>
    </message>
    <message>
        <source>Nobody has an account with the login name “%1”. Nobody was enrolled. Correct the name, or leave the field empty.</source>
        <translation>Κανείς δεν έχει λογαριασμό με το όνομα χρήστη «%1». Κανείς δεν εγγράφηκε. Διορθώστε το όνομα ή αφήστε το πεδίο κενό.</translation>
    </message>
    <message>
        <source>Enter an identity first, or a login name.</source>
        <translation>Εισαγάγετε πρώτα ταυτότητα ή όνομα χρήστη.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::EraseDialog</name>
    <message>
        <source>Erase %1</source>
        <translation>Διαγραφή στοιχείων: %1</translation>
    </message>
    <message>
        <source>This cannot be undone. Disabling the account keeps everything and can be undone.</source>
        <translation>Αυτό δεν αναιρείται. Η απενεργοποίηση του λογαριασμού διατηρεί τα πάντα και αναιρείται.</translation>
    </message>
    <message>
        <source>Overwritten: name, code, password, comments and reasons in free text.</source>
        <translation>Σβήνονται οριστικά: όνομα, ψευδώνυμο, κωδικός πρόσβασης, σχόλια και αιτιολογίες σε ελεύθερο κείμενο.</translation>
    </message>
    <message>
        <source>Kept without a name: sessions, scores, and a note of when and why the person was erased. Earlier backups still contain the person until they are deleted; restoring one erases the person again.</source>
        <translation>Διατηρούνται χωρίς όνομα: συνεδρίες, βαθμολογίες και σημείωση πότε και γιατί έγινε η διαγραφή. Παλαιότερα αντίγραφα ασφαλείας περιέχουν ακόμη το άτομο ώσπου να διαγραφούν τα ίδια· κατά την επαναφορά το άτομο διαγράφεται ξανά.</translation>
    </message>
    <message>
        <source>Consent is withdrawn: overwrite the recordings too</source>
        <translation>Η συγκατάθεση ανακλήθηκε: να σβηστούν και οι καταγραφές</translation>
    </message>
    <message>
        <source>Type the login name to confirm: %1</source>
        <translation>Για επιβεβαίωση πληκτρολογήστε το όνομα χρήστη: %1</translation>
    </message>
    <message>
        <source>%1 was erased. Sessions and scores are kept without a name.</source>
        <translation>Διαγράφηκε: %1. Οι συνεδρίες και οι βαθμολογίες διατηρούνται χωρίς όνομα.</translation>
    </message>
    <message>
        <source>%1 cannot be erased now. You cannot erase yourself, and no session may be running.</source>
        <translation>Δεν γίνεται τώρα διαγραφή: %1. Δεν μπορείτε να διαγράψετε τον εαυτό σας και δεν πρέπει να υπάρχει συνεδρία σε εξέλιξη.</translation>
    </message>
    <message>
        <source>This erases an account, and the identity of the person in studies whose key table lists the account. A participant who is known only by a code is erased with &quot;Erase a participant&quot;.</source>
        <translation>Εδώ διαγράφονται ένας λογαριασμός και η ταυτότητα του προσώπου στις μελέτες που ο πίνακας κλειδιών τους αναφέρει τον λογαριασμό. Όποιος είναι γνωστός μόνο με κωδικό διαγράφεται με το «Διαγραφή συμμετέχοντα».</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::EraseParticipantDialog</name>
    <message>
        <source>Erase a study participant</source>
        <translation>Διαγραφή στοιχείων συμμετέχοντα σε μελέτη</translation>
    </message>
    <message>
        <source>This cannot be undone.</source>
        <translation>Δεν αναιρείται.</translation>
    </message>
    <message>
        <source>Participant who has withdrawn</source>
        <translation>Συμμετέχων που αποσύρθηκε</translation>
    </message>
    <message>
        <source>Reading the studies …</source>
        <translation>Ανάγνωση των μελετών …</translation>
    </message>
    <message>
        <source>The studies could not be read.
%1</source>
        <translation>Οι μελέτες δεν διαβάστηκαν.
%1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Overwritten: who the participant was, the answers to questionnaires, comments on their sessions and, as the participant wished, the recordings. Kept under the code: runs and trials.</source>
        <translation>Σβήνονται οριστικά: η ταυτότητα του συμμετέχοντα, οι απαντήσεις στα ερωτηματολόγια, τα σχόλια στις συνεδρίες του και, όπως ζήτησε, οι καταγραφές. Διατηρούνται με τον κωδικό: εκτελέσεις και δοκιμές.</translation>
    </message>
    <message>
        <source>Overwritten: who the participant was, the answers to questionnaires and comments on their sessions. Kept under the code: runs, trials and recordings; the participant did not ask for the recordings to be erased.</source>
        <translation>Σβήνονται οριστικά: η ταυτότητα του συμμετέχοντα, οι απαντήσεις στα ερωτηματολόγια και τα σχόλια στις συνεδρίες του. Διατηρούνται με τον κωδικό: εκτελέσεις, δοκιμές και καταγραφές· δεν ζητήθηκε η διαγραφή των καταγραφών.</translation>
    </message>
    <message>
        <source>%1 was erased. Runs and trials are kept under the code.</source>
        <translation>Διαγράφηκε: %1. Οι εκτελέσεις και οι δοκιμές διατηρούνται με τον κωδικό.</translation>
    </message>
    <message>
        <source>%1 cannot be erased now: no session of the participant may be running.</source>
        <translation>Δεν γίνεται τώρα διαγραφή: %1. Δεν πρέπει να υπάρχει συνεδρία του συμμετέχοντα σε εξέλιξη.</translation>
    </message>
    <message>
        <source>This erases the identity behind the code in one study; if the same person has an account, it stays. To erase an account, choose the person in the list and press &quot;Erase&quot;.</source>
        <translation>Εδώ διαγράφεται η ταυτότητα πίσω από τον κωδικό σε μία μελέτη· αν το ίδιο πρόσωπο έχει λογαριασμό, αυτός παραμένει. Για να διαγράψετε λογαριασμό, επιλέξτε το πρόσωπο στον κατάλογο και πατήστε «Διαγραφή στοιχείων».</translation>
    </message>
    <message>
        <source>No participant who has withdrawn is waiting to be erased. Researchers withdraw a participant on the study&apos;s Run screen.</source>
        <translation>Κανένας συμμετέχων που αποσύρθηκε δεν περιμένει διαγραφή. Οι ερευνητές αποσύρουν συμμετέχοντες στην οθόνη «Διεξαγωγή» της μελέτης.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ErasureDialog</name>
    <message>
        <source>Reason (kept)</source>
        <translation>Αιτιολογία (διατηρείται)</translation>
    </message>
    <message>
        <source>Your own password</source>
        <translation>Ο δικός σας κωδικός πρόσβασης</translation>
    </message>
    <message>
        <source>Erase permanently</source>
        <translation>Οριστική διαγραφή</translation>
    </message>
    <message>
        <source>The erasure of %1 is not complete: the file may still contain old copies. Press the button again to continue where it stopped.
%2</source>
        <translation>Η διαγραφή δεν ολοκληρώθηκε (%1): το αρχείο ίσως περιέχει ακόμη παλιά αντίγραφα. Πατήστε ξανά το κουμπί για να συνεχιστεί από εκεί που σταμάτησε.
%2</translation>
    </message>
    <message>
        <source>%1 was not erased.
%2</source>
        <translation>Δεν διαγράφηκε: %1.
%2</translation>
    </message>
    <message>
        <source>Nobody was erased.</source>
        <translation>Δεν έγινε διαγραφή.</translation>
    </message>
    <message>
        <source>Nobody was erased.
%1</source>
        <translation>Δεν έγινε διαγραφή.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExerciseCard</name>
    <message>
        <source>Passed with shown force</source>
        <translation>Επιτυχία με προβολή δύναμης</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s), not passed yet</source>
        <translation>
            <numerusform>%n προσπάθεια, χωρίς επιτυχία ακόμη</numerusform>
            <numerusform>%n προσπάθειες, χωρίς επιτυχία ακόμη</numerusform>
        </translation>
    </message>
    <message>
        <source>New</source>
        <translation>Νέο</translation>
    </message>
    <message>
        <source>Level %1: %2</source>
        <translation>Επίπεδο %1: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 · next step</source>
        <translation>%1 · επόμενο βήμα</translation>
    </message>
    <message>
        <source>Passed with felt and with shown force</source>
        <translation>Επιτυχία με αισθητή δύναμη και με προβολή</translation>
    </message>
    <message>
        <source>Passed with felt force</source>
        <translation>Επιτυχία με αισθητή δύναμη</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExerciseSetupScreen</name>
    <message>
        <source>What is measured</source>
        <translation>Τι μετράται</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Όριο επιτυχίας</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Επίπεδο</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Συσκευή</translation>
    </message>
    <message>
        <source>Familiarisation: recorded, but not counted</source>
        <translation>Εξοικείωση: καταγράφεται, δεν μετράει</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Έναρξη</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Άσκηση</translation>
    </message>
    <message>
        <source>Here you see what an exercise asks for, what is measured and when it is passed.

Everything is already chosen: press &quot;Start&quot; (or Enter) to begin. Choose another level, or a device, if you want. &quot;Demonstrate&quot; lets you watch a scripted operator; its session does not count for anyone. A file with a recorded movement can be replayed through the same exercise.

&quot;Hand and workspace&quot; sets which hand you work with, how far the tool moves when your hand moves, and where the middle of the field lies. A familiarisation is recorded, but never counted.</source>
        <translation>Εδώ βλέπετε τι ζητά μια άσκηση, τι μετράται και πότε υπάρχει επιτυχία.

Όλα είναι ήδη επιλεγμένα: πατήστε «Έναρξη» (ή Enter) για να ξεκινήσετε. Επιλέξτε άλλο επίπεδο ή συσκευή, αν θέλετε. Με την «Επίδειξη» παρακολουθείτε έναν εικονικό χειριστή· η συνεδρία του δεν μετράει για κανέναν. Ένα αρχείο με καταγεγραμμένη κίνηση μπορεί να αναπαραχθεί στην ίδια άσκηση.

Το «Χέρι και χώρος εργασίας» ορίζει με ποιο χέρι εργάζεστε, πόσο κινείται το εργαλείο ως προς το χέρι σας και πού είναι το κέντρο του πεδίου. Μια εξοικείωση καταγράφεται, αλλά δεν μετράει ποτέ.</translation>
    </message>
    <message>
        <source>This exercise does not exist</source>
        <translation>Αυτή η άσκηση δεν υπάρχει</translation>
    </message>
    <message>
        <source>The content on this station has no exercise of that name.</source>
        <translation>Το περιεχόμενο αυτού του σταθμού δεν έχει άσκηση με αυτό το όνομα.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Αρχική</translation>
    </message>
    <message>
        <source>Your earlier results could not be read. You can still train.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση των προηγούμενων αποτελεσμάτων σας. Μπορείτε ωστόσο να εκπαιδευτείτε.</translation>
    </message>
    <message>
        <source>This level has no pass mark.</source>
        <translation>Αυτό το επίπεδο δεν έχει όριο επιτυχίας.</translation>
    </message>
    <message>
        <source>Level %1. %2</source>
        <translation>Επίπεδο %1. %2</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Παρακολούθηση</translation>
    </message>
    <message>
        <source>Watch first</source>
        <translation>Δείτε πρώτα</translation>
    </message>
    <message>
        <source>Watch a scripted expert at this level. Nothing is counted.</source>
        <translation>Παρακολουθήστε σε αυτό το επίπεδο έναν προγραμματισμένο ειδικό. Τίποτα δεν βαθμολογείται.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExercisesScreen</name>
    <message>
        <source>Exercises</source>
        <translation>Ασκήσεις</translation>
    </message>
    <message>
        <source>All exercises of this site and their levels.

Each level says whether you have passed it. Choose one to see what is measured and what counts as passed, choose a device, and start.</source>
        <translation>Όλες οι ασκήσεις αυτού του κέντρου και τα επίπεδά τους.

Κάθε επίπεδο δείχνει αν το έχετε περάσει. Επιλέξτε ένα για να δείτε τι μετράται και πότε υπάρχει επιτυχία, επιλέξτε συσκευή και ξεκινήστε.</translation>
    </message>
    <message>
        <source>Loading the exercises …</source>
        <translation>Φόρτωση ασκήσεων …</translation>
    </message>
    <message>
        <source>The exercises could not be loaded.</source>
        <translation>Δεν ήταν δυνατή η φόρτωση των ασκήσεων.</translation>
    </message>
    <message>
        <source>There are no exercises</source>
        <translation>Δεν υπάρχουν ασκήσεις</translation>
    </message>
    <message>
        <source>The content folder of this site contains no exercises. Ask an administrator.</source>
        <translation>Ο φάκελος περιεχομένου αυτού του κέντρου δεν περιέχει ασκήσεις. Απευθυνθείτε σε διαχειριστή.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExperimenterGate</name>
    <message>
        <source>For the experimenter</source>
        <translation>Για τον πειραματιστή</translation>
    </message>
    <message>
        <source>Password of %1</source>
        <translation>Κωδικός πρόσβασης: %1</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Συνέχεια</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExperimenterPanel</name>
    <message>
        <source>Experimenter</source>
        <translation>Πειραματιστής</translation>
    </message>
    <message>
        <source>Discard this trial</source>
        <translation>Ακύρωση δοκιμής</translation>
    </message>
    <message>
        <source>It does not count and is presented again.</source>
        <translation>Δεν μετρά και παρουσιάζεται ξανά.</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Παύση (Διάστημα)</translation>
    </message>
    <message>
        <source>Stop …</source>
        <translation>Διακοπή …</translation>
    </message>
    <message>
        <source>Condition %1 (sealed)</source>
        <translation>Συνθήκη %1 (σφραγισμένη)</translation>
    </message>
    <message>
        <source>%1 of at most %2 trials</source>
        <translation>%1 από το πολύ %2 δοκιμές</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n δοκιμή</numerusform>
            <numerusform>%n δοκιμές</numerusform>
        </translation>
    </message>
    <message>
        <source>Practice, not scored. %1</source>
        <translation>Εξάσκηση, δεν βαθμολογείται. %1</translation>
    </message>
    <message>
        <source>%1, %2 repeated</source>
        <translation>%1, %2 επαναλήφθηκαν</translation>
    </message>
    <message>
        <source>Resume (Space)</source>
        <translation>Συνέχεια (Διάστημα)</translation>
    </message>
    <message>
        <source>The estimate stays sealed until the study is unblinded.</source>
        <translation>Η εκτίμηση μένει σφραγισμένη ώσπου να αρθεί η τυφλότητα.</translation>
    </message>
    <message>
        <source>The fidelity of each trial will appear here.</source>
        <translation>Η πιστότητα κάθε δοκιμής θα εμφανίζεται εδώ.</translation>
    </message>
    <message>
        <source>Last trial: counted.</source>
        <translation>Τελευταία δοκιμή: μέτρησε.</translation>
    </message>
    <message>
        <source>Last trial: repeated. %1.</source>
        <translation>Τελευταία δοκιμή: επαναλαμβάνεται. %1.</translation>
    </message>
    <message>
        <source>Peak force %1 N, mean speed %2 mm/s, %3 contacts, %4 s.</source>
        <translation>Μέγιστη δύναμη %1 N, μέση ταχύτητα %2 mm/s, %3 επαφές, %4 s.</translation>
    </message>
    <message>
        <source>Felt value off by %1, late ticks %2, device at its limit %3.</source>
        <translation>Απόκλιση αισθητής τιμής %1, καθυστερημένοι κύκλοι %2, συσκευή στο όριο %3.</translation>
    </message>
    <message>
        <source>Force error %1 N.</source>
        <translation>Σφάλμα δύναμης %1 N.</translation>
    </message>
    <message>
        <source>The device measures no force.</source>
        <translation>Η συσκευή δεν μετρά δύναμη.</translation>
    </message>
    <message numerus="yes">
        <source>The device cannot render all differences: %n remain.</source>
        <translation>
            <numerusform>Η συσκευή δεν αποδίδει όλες τις διαφορές: μένει %n.</numerusform>
            <numerusform>Η συσκευή δεν αποδίδει όλες τις διαφορές: μένουν %n.</numerusform>
        </translation>
    </message>
    <message>
        <source>The estimate will appear here after the first scored trials.</source>
        <translation>Η εκτίμηση θα εμφανιστεί εδώ μετά τις πρώτες βαθμολογημένες δοκιμές.</translation>
    </message>
    <message>
        <source>Weber fraction %1</source>
        <translation>Κλάσμα Weber %1</translation>
    </message>
    <message>
        <source>Weber fraction %1 (95 %: %2)</source>
        <translation>Κλάσμα Weber %1 (95 %: %2)</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Δοκιμή</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Κλάσμα Weber (%)</translation>
    </message>
    <message>
        <source>procedure %1</source>
        <translation>διαδικασία %1</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Force is shown, not felt, so rendering is not limited.</source>
        <translation>Η δύναμη προβάλλεται, δεν γίνεται αισθητή· η απόδοση δεν έχει περιορισμό.</translation>
    </message>
    <message>
        <source>Measured delay of the device: %1 ms.</source>
        <translation>Μετρημένη καθυστέρηση της συσκευής: %1 ms.</translation>
    </message>
    <message>
        <source>The delay of this device was never measured. A cautious value of %1 ms is assumed, based on what the device states.</source>
        <translation>Η καθυστέρηση αυτής της συσκευής δεν μετρήθηκε ποτέ. Με βάση όσα δηλώνει η συσκευή, λαμβάνεται μια ασφαλής τιμή: %1 ms.</translation>
    </message>
    <message>
        <source>Mean speed %1 mm/s, %2 contacts, %3 s, late ticks %4. Forces stay sealed: they would reveal the condition.</source>
        <translation>Μέση ταχύτητα %1 mm/s, %2 επαφές, %3 s, καθυστερημένοι κύκλοι %4. Οι δυνάμεις μένουν σφραγισμένες: θα πρόδιδαν τη συνθήκη.</translation>
    </message>
    <message>
        <source>It will not count</source>
        <translation>Δεν θα μετρήσει</translation>
    </message>
    <message>
        <source>The bias will appear here after the first scored trials.</source>
        <translation>Η μετατόπιση θα εμφανιστεί εδώ μετά τις πρώτες βαθμολογημένες δοκιμές.</translation>
    </message>
    <message>
        <source>Bias so far: %1 mm to the right, %2 mm away from you. Mean error %3 mm per axis.</source>
        <translation>Μετατόπιση ως τώρα: %1 mm δεξιά, %2 mm προς τα πίσω. Μέσο σφάλμα %3 mm ανά άξονα.</translation>
    </message>
    <message>
        <source>marks</source>
        <translation>σημεία</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FieldGrid</name>
    <message>
        <source>“%1” was not accepted: enter a number without a unit. The value is still %2.</source>
        <translation>Το «%1» δεν έγινε δεκτό: πληκτρολογήστε έναν αριθμό χωρίς μονάδα. Ισχύει ακόμη %2.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: enter a value in %2. The value is still %3.</source>
        <translation>Το «%1» δεν έγινε δεκτό: πληκτρολογήστε μια τιμή σε %2. Ισχύει ακόμη %3.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: it has more decimals than this field keeps. The value is still %2.</source>
        <translation>Το «%1» δεν έγινε δεκτό: έχει περισσότερα δεκαδικά από όσα αποθηκεύονται εδώ. Ισχύει ακόμη %2.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: choose a value from %2 to %3. The value is still %4.</source>
        <translation>Το «%1» δεν έγινε δεκτό: επιλέξτε τιμή από %2 έως %3. Ισχύει ακόμη %4.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: enter a whole number from %2 to %3. The value is still %4.</source>
        <translation>Το «%1» δεν έγινε δεκτό: πληκτρολογήστε ακέραιο αριθμό από %2 έως %3. Ισχύει ακόμη %4.</translation>
    </message>
    <message>
        <source>%1 to %2, usually %3.</source>
        <translation>%1 έως %2, συνήθως %3.</translation>
    </message>
    <message>
        <source>A number is needed here. The value is still %1.</source>
        <translation>Εδώ χρειάζεται αριθμός. Ισχύει ακόμη %1.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: each number has to be from %2 to %3.</source>
        <translation>Το «%1» δεν έγινε δεκτό: κάθε αριθμός πρέπει να είναι από %2 έως %3.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FindingsBox</name>
    <message>
        <source>Findings</source>
        <translation>Ευρήματα</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Αφαίρεση</translation>
    </message>
    <message>
        <source>Take the selected finding back (Delete)</source>
        <translation>Αφαίρεση του επιλεγμένου ευρήματος (Delete)</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Σκληρότητα</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Βεβαιότητα</translation>
    </message>
    <message>
        <source>Nothing found: end the trial (D)</source>
        <translation>Δεν βρέθηκε τίποτα (D)</translation>
    </message>
    <message>
        <source>Nothing more to report (D)</source>
        <translation>Τίποτε άλλο (D)</translation>
    </message>
    <message>
        <source>No finding is selected.</source>
        <translation>Δεν έχει επιλεγεί εύρημα.</translation>
    </message>
    <message>
        <source>Still missing:
%1
Press again to end the trial without it.</source>
        <translation>Λείπουν ακόμη:
%1
Πατήστε ξανά για να τελειώσει η δοκιμή χωρίς αυτά.</translation>
    </message>
    <message>
        <source>None yet. Press where the tissue is firmer, then mark the place (Enter).</source>
        <translation>Κανένα ακόμη. Πιέστε όπου ο ιστός είναι πιο σκληρός και σημειώστε τη θέση (Enter).</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FirstStartScreen</name>
    <message>
        <source>Welcome</source>
        <translation>Καλωσορίσατε</translation>
    </message>
    <message>
        <source>Chiron is a training suite for the sense of touch in minimally invasive surgery.

&quot;Set up this site&quot; creates an empty site on this computer and its first administrator, who can add the others. It takes about a minute.

&quot;Open the demonstration site&quot; creates a separate site with invented people and scripted sessions, so that you can look around. It does not affect a site that you set up later. Until you set one up, this choice appears at every start.</source>
        <translation>Το Chiron είναι ένα σύστημα εκπαίδευσης της αίσθησης της αφής στην ελάχιστα επεμβατική χειρουργική.

Η «Δημιουργία κέντρου» φτιάχνει ένα κενό κέντρο σε αυτόν τον υπολογιστή και τον πρώτο διαχειριστή του, που μπορεί να προσθέσει τους υπόλοιπους. Διαρκεί περίπου ένα λεπτό.

Το «Άνοιγμα κέντρου επίδειξης» φτιάχνει ένα ξεχωριστό κέντρο με φανταστικά άτομα και προσομοιωμένες συνεδρίες, για να δείτε το πρόγραμμα. Δεν επηρεάζει κέντρο που θα δημιουργηθεί αργότερα· η επιλογή αυτή εμφανίζεται σε κάθε εκκίνηση μέχρι τότε.</translation>
    </message>
    <message>
        <source>The recovery code is not shown again. Write it down and tick the box first.</source>
        <translation>Ο κωδικός ανάκτησης δεν εμφανίζεται ξανά. Πρώτα σημειώστε τον και επιλέξτε το πλαίσιο.</translation>
    </message>
    <message>
        <source>Welcome to Chiron</source>
        <translation>Καλωσορίσατε στο Chiron</translation>
    </message>
    <message>
        <source>Learn by touch: practise, see what your hand did, and know when you are ready.</source>
        <translation>Μάθετε με την αφή: εξασκηθείτε, δείτε τι έκανε το χέρι σας και μάθετε πότε είστε έτοιμοι.</translation>
    </message>
    <message>
        <source>Set up this site</source>
        <translation>Δημιουργία κέντρου</translation>
    </message>
    <message>
        <source>Set up your own site</source>
        <translation>Δημιουργήστε το δικό σας κέντρο</translation>
    </message>
    <message>
        <source>You become its administrator. People, sessions and scores stay on this computer.</source>
        <translation>Γίνεστε διαχειριστής/-τρια του κέντρου. Τα άτομα, οι συνεδρίες και οι βαθμολογίες μένουν σε αυτόν τον υπολογιστή.</translation>
    </message>
    <message>
        <source>Open the demonstration site</source>
        <translation>Άνοιγμα κέντρου επίδειξης</translation>
    </message>
    <message>
        <source>Look around first</source>
        <translation>Δείτε πρώτα το πρόγραμμα</translation>
    </message>
    <message>
        <source>Invented people and scripted sessions at every level. Creating them takes about a minute, only once.</source>
        <translation>Φανταστικά άτομα και προσομοιωμένες συνεδρίες σε κάθε επίπεδο. Η δημιουργία διαρκεί περίπου ένα λεπτό, μία φορά.</translation>
    </message>
    <message>
        <source>The site was not created.
%1</source>
        <translation>Το κέντρο δεν δημιουργήθηκε.
%1</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Πίσω</translation>
    </message>
    <message>
        <source>Opening the demonstration site …</source>
        <translation>Άνοιγμα του κέντρου επίδειξης …</translation>
    </message>
    <message>
        <source>Creating the demonstration site: people, and scripted sessions at every level …</source>
        <translation>Δημιουργία του κέντρου επίδειξης: άτομα και προσομοιωμένες συνεδρίες σε κάθε επίπεδο …</translation>
    </message>
    <message>
        <source>Creation of the demonstration site was stopped; what had been created was removed.</source>
        <translation>Η δημιουργία του κέντρου επίδειξης διακόπηκε· ό,τι είχε δημιουργηθεί αφαιρέθηκε.</translation>
    </message>
    <message>
        <source>The demonstration site could not be opened.</source>
        <translation>Το κέντρο επίδειξης δεν ήταν δυνατό να ανοίξει.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ForceBar</name>
    <message>
        <source>over the limit</source>
        <translation>πάνω από το όριο</translation>
    </message>
    <message>
        <source>%1 %2, over the limit</source>
        <translation>%1 %2, πάνω από το όριο</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FormDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Άκυρο</translation>
    </message>
    <message>
        <source>Working …</source>
        <translation>Σε εξέλιξη …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Κλείσιμο</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FreezeDialog</name>
    <message>
        <source>Freeze %1</source>
        <translation>Οριστικοποίηση: %1</translation>
    </message>
    <message>
        <source>From now on nobody can change the design. Participants can be enrolled, each condition gets a sealed code, and every export carries this SHA-256 of the design:</source>
        <translation>Από εδώ και πέρα κανείς δεν μπορεί να αλλάξει το σχέδιο. Μπορούν να εγγραφούν συμμετέχοντες, κάθε συνθήκη παίρνει σφραγισμένο κωδικό, και κάθε εξαγωγή φέρει αυτό το SHA-256 του σχεδίου:</translation>
    </message>
    <message numerus="yes">
        <source>%n condition(s)</source>
        <translation>
            <numerusform>%n συνθήκη</numerusform>
            <numerusform>%n συνθήκες</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) planned</source>
        <translation>
            <numerusform>%n συμμετέχων προβλέπεται</numerusform>
            <numerusform>%n συμμετέχοντες προβλέπονται</numerusform>
        </translation>
    </message>
    <message>
        <source>This cannot be undone. To change the study later, copy it into a new one.</source>
        <translation>Αυτό δεν αναιρείται. Για να αλλάξετε τη μελέτη αργότερα, αντιγράψτε την σε νέα.</translation>
    </message>
    <message>
        <source>Freeze the design</source>
        <translation>Οριστικοποίηση</translation>
    </message>
    <message>
        <source>The study could not be frozen.
%1</source>
        <translation>Η μελέτη δεν οριστικοποιήθηκε.
%1</translation>
    </message>
    <message>
        <source>Frozen. Participants can be enrolled now.</source>
        <translation>Οριστικοποιήθηκε. Τώρα μπορούν να εγγραφούν συμμετέχοντες.</translation>
    </message>
    <message>
        <source>I have seen the points that are worth a look and freeze the design anyway</source>
        <translation>Είδα τα σημεία που χρειάζονται προσοχή και οριστικοποιώ παρ’ όλα αυτά το σχέδιο</translation>
    </message>
    <message>
        <source>What is marked in red must be corrected first: after freezing, nobody can change it.</source>
        <translation>Όσα σημειώνονται με κόκκινο πρέπει πρώτα να διορθωθούν: μετά την οριστικοποίηση δεν μπορεί να τα αλλάξει κανείς.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::GeneralPage</name>
    <message>
        <source>Planned participants</source>
        <translation>Προβλεπόμενοι συμμετέχοντες</translation>
    </message>
    <message>
        <source>Number of participants</source>
        <translation>Αριθμός συμμετεχόντων</translation>
    </message>
    <message>
        <source>Source of the design</source>
        <translation>Πηγή του σχεδίου</translation>
    </message>
    <message>
        <source>Where the design was published, with its DOI; empty for a design of your own.</source>
        <translation>Πού δημοσιεύτηκε το σχέδιο, με το DOI του· κενό για δικό σας σχέδιο.</translation>
    </message>
    <message>
        <source>One or two sentences: what is to be found out, and what is expected. It is frozen with the study.</source>
        <translation>Μία ή δύο προτάσεις: τι θέλετε να διαπιστώσετε και τι αναμένεται. Οριστικοποιείται μαζί με τη μελέτη.</translation>
    </message>
    <message>
        <source>For example: whether tubes of 60 N/m and 120 N/m have the same Weber fraction. We expect no difference.</source>
        <translation>Για παράδειγμα: αν σωλήνες 60 N/m και 120 N/m έχουν το ίδιο κλάσμα Weber. Δεν αναμένουμε διαφορά.</translation>
    </message>
    <message>
        <source>Ethics approval</source>
        <translation>Έγκριση δεοντολογίας</translation>
    </message>
    <message>
        <source>The committee with the number and date of its approval, or why none is needed. It is frozen with the study.</source>
        <translation>Η επιτροπή με τον αριθμό και την ημερομηνία της έγκρισης, ή γιατί δεν χρειάζεται. Οριστικοποιείται μαζί με τη μελέτη.</translation>
    </message>
    <message>
        <source>What participants agree to before their first trial. The text that was shown is stored with each consent.</source>
        <translation>Σε τι συγκατατίθενται οι συμμετέχοντες πριν από την πρώτη δοκιμή. Με κάθε συγκατάθεση φυλάσσεται το κείμενο που παρουσιάστηκε.</translation>
    </message>
    <message>
        <source>Title (required)</source>
        <translation>Τίτλος (υποχρεωτικό)</translation>
    </message>
    <message>
        <source>Aim (required)</source>
        <translation>Σκοπός (υποχρεωτικό)</translation>
    </message>
    <message>
        <source>Ethics approval (required)</source>
        <translation>Έγκριση δεοντολογίας (υποχρεωτικό)</translation>
    </message>
    <message>
        <source>Consent text (required)</source>
        <translation>Κείμενο συγκατάθεσης (υποχρεωτικό)</translation>
    </message>
    <message>
        <source>The study&apos;s name in lists, reports and exports.</source>
        <translation>Το όνομα της μελέτης σε λίστες, αναφορές και εξαγωγές.</translation>
    </message>
    <message>
        <source>Aim and ethics</source>
        <translation>Σκοπός και δεοντολογία</translation>
    </message>
    <message>
        <source>How many people are to take part; the page “Expected precision” shows which difference this number can detect.</source>
        <translation>Πόσα άτομα θα λάβουν μέρος· η σελίδα «Αναμενόμενη ακρίβεια» δείχνει ποια διαφορά μπορεί να ανιχνεύσει ο αριθμός αυτός.</translation>
    </message>
    <message>
        <source>Consent and source</source>
        <translation>Συγκατάθεση και πηγή</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::GraspPanel</name>
    <message>
        <source>Holding time completed</source>
        <translation>Ολοκληρωμένος χρόνος κρατήματος</translation>
    </message>
    <message>
        <source>Holding time: %p %</source>
        <translation>Χρόνος κρατήματος: %p %</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>Τάση</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Σύσφιξη</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Δύναμη</translation>
    </message>
    <message>
        <source>Force, right</source>
        <translation>Δύναμη, δεξιά</translation>
    </message>
    <message>
        <source>Force, left</source>
        <translation>Δύναμη, αριστερά</translation>
    </message>
    <message>
        <source>right</source>
        <translation>δεξιά</translation>
    </message>
    <message>
        <source>away</source>
        <translation>εμπρός</translation>
    </message>
    <message>
        <source>up</source>
        <translation>πάνω</translation>
    </message>
    <message>
        <source>jaw (°)</source>
        <translation>σιαγόνες (°)</translation>
    </message>
    <message>
        <source>%1, tip (mm)</source>
        <translation>%1, άκρη (mm)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Tension (N)</source>
        <translation>Τάση (N)</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Σύσφιξη (N)</translation>
    </message>
    <message>
        <source>Force, right (N)</source>
        <translation>Δύναμη, δεξιά (N)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Δύναμη (N)</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Ταχύτητα (mm/s)</translation>
    </message>
    <message>
        <source>Stretched by %1 mm</source>
        <translation>Τέντωμα κατά %1 mm</translation>
    </message>
    <message>
        <source>Pull of the load, downwards: %1 N</source>
        <translation>Έλξη του φορτίου, προς τα κάτω: %1 N</translation>
    </message>
    <message>
        <source>Pull on the fold</source>
        <translation>Έλξη της πτυχής</translation>
    </message>
    <message>
        <source>Force, instrument %1</source>
        <translation>Δύναμη, εργαλείο %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::GroupPage</name>
    <message>
        <source>Nobody has run this condition yet. Each participant&apos;s result appears here after their first run.</source>
        <translation>Κανείς δεν έχει εκτελέσει ακόμη αυτή τη συνθήκη. Το αποτέλεσμα κάθε συμμετέχοντα εμφανίζεται εδώ μετά την πρώτη του εκτέλεση.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Ομάδα</translation>
    </message>
    <message>
        <source>95 %: %1</source>
        <translation>95 %: %1</translation>
    </message>
    <message>
        <source>prediction for a new participant: %1</source>
        <translation>πρόβλεψη για νέο συμμετέχοντα: %1</translation>
    </message>
    <message>
        <source>JND %1</source>
        <translation>JND %1</translation>
    </message>
    <message>
        <source>Rankings entirely correct: %1 of %2 (%3; chance level 16.7 %)</source>
        <translation>Πλήρως σωστές κατατάξεις: %1 από %2 (%3· επίπεδο τύχης 16,7 %)</translation>
    </message>
    <message>
        <source>Weber fraction of each participant</source>
        <translation>Κλάσμα Weber κάθε συμμετέχοντα</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Κλάσμα Weber (%)</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Συμμετέχων</translation>
    </message>
    <message>
        <source>No estimate yet</source>
        <translation>Καμία εκτίμηση ακόμη</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Εκτελέσεις</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Κωδικός</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Κλάσμα Weber</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>Διάστημα 95 %</translation>
    </message>
    <message>
        <source>JND</source>
        <translation>JND</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Δοκιμές</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Εκτέλεση</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Προειδοποιήσεις</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>σφραγισμένο</translation>
    </message>
    <message>
        <source>%1 (%2 repeated)</source>
        <translation>%1 (%2 επαναλήφθηκαν)</translation>
    </message>
    <message>
        <source>Rankings entirely correct: %1 of %2 (%3; chance level 16.7 % or less)</source>
        <translation>Πλήρως σωστές κατατάξεις: %1 από %2 (%3· επίπεδο τύχης έως 16,7 %)</translation>
    </message>
    <message>
        <source>Prior influence</source>
        <translation>Μερίδιο της εκ των προτέρων κατανομής</translation>
    </message>
    <message>
        <source>Compare the conditions</source>
        <translation>Σύγκριση των συνθηκών</translation>
    </message>
    <message>
        <source>Weber fraction (random effects)</source>
        <translation>Κλάσμα Weber (τυχαίες επιδράσεις)</translation>
    </message>
    <message>
        <source>Exponent of the power law</source>
        <translation>Εκθέτης του νόμου δύναμης</translation>
    </message>
    <message>
        <source>In the group</source>
        <translation>Στην ομάδα</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::HeaderBar</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 · familiarisation, not counted</source>
        <translation>%1 · εξοικείωση, δεν μετράει</translation>
    </message>
    <message>
        <source>Sound off</source>
        <translation>Σίγαση ήχου</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <translation>Δοκιμή %1 από %2</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>ακόμη %1&#xa0;s</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Ενεργοποίηση ήχου</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::HeadlineCard</name>
    <message>
        <source>No pass mark</source>
        <translation>Χωρίς όριο επιτυχίας</translation>
    </message>
    <message>
        <source>Pass mark %1</source>
        <translation>Όριο επιτυχίας %1</translation>
    </message>
    <message>
        <source>Met: pass mark %1</source>
        <translation>Επετεύχθη: όριο επιτυχίας %1</translation>
    </message>
    <message>
        <source>Not met: pass mark %1</source>
        <translation>Δεν επετεύχθη: όριο επιτυχίας %1</translation>
    </message>
    <message>
        <source>Benchmark %1 (%2)</source>
        <translation>Τιμή αναφοράς %1 (%2)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::HomeScreen</name>
    <message>
        <source>Every level is passed</source>
        <translation>Επιτυχία σε όλα τα επίπεδα</translation>
    </message>
    <message>
        <source>Continue where you left off</source>
        <translation>Συνεχίστε από εκεί που μείνατε</translation>
    </message>
    <message>
        <source>Your next step</source>
        <translation>Το επόμενο βήμα σας</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Συνέχεια</translation>
    </message>
    <message>
        <source>My progress</source>
        <translation>Η πρόοδός μου</translation>
    </message>
    <message>
        <source>Nothing recorded yet. Your first session appears here once it has ended.</source>
        <translation>Δεν υπάρχει ακόμη καταγραφή. Η πρώτη σας συνεδρία θα εμφανιστεί εδώ μόλις τελειώσει.</translation>
    </message>
    <message>
        <source>All my results</source>
        <translation>Όλα τα αποτελέσματά μου</translation>
    </message>
    <message>
        <source>Sessions to review</source>
        <translation>Συνεδρίες προς αξιολόγηση</translation>
    </message>
    <message>
        <source>Nobody has trained yet. Trainees&apos; sessions will appear here, interrupted ones first.</source>
        <translation>Δεν έχει γίνει ακόμη εκπαίδευση. Εδώ θα εμφανίζονται οι συνεδρίες των εκπαιδευομένων, πρώτα όσες διακόπηκαν.</translation>
    </message>
    <message>
        <source>All sessions</source>
        <translation>Όλες οι συνεδρίες</translation>
    </message>
    <message>
        <source>Recent training</source>
        <translation>Πρόσφατη εκπαίδευση</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) in the last 7 days</source>
        <translation>
            <numerusform>%n συνεδρία τις τελευταίες 7 ημέρες</numerusform>
            <numerusform>%n συνεδρίες τις τελευταίες 7 ημέρες</numerusform>
        </translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Δεδομένα</translation>
    </message>
    <message>
        <source>Every recorded session, by code instead of by name: filter the list, play sessions back, save the list as a table.</source>
        <translation>Όλες οι καταγεγραμμένες συνεδρίες, με ψευδώνυμο αντί για όνομα: φιλτράρετε τη λίστα, αναπαράγετε συνεδρίες, αποθηκεύστε τη λίστα ως πίνακα.</translation>
    </message>
    <message>
        <source>Open the data</source>
        <translation>Άνοιγμα δεδομένων</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Άτομα</translation>
    </message>
    <message numerus="yes">
        <source>%n account(s) can log in.</source>
        <translation>
            <numerusform>%n λογαριασμός μπορεί να συνδεθεί.</numerusform>
            <numerusform>%n λογαριασμοί μπορούν να συνδεθούν.</numerusform>
        </translation>
    </message>
    <message>
        <source>Open people</source>
        <translation>Άνοιγμα ατόμων</translation>
    </message>
    <message>
        <source>Storage</source>
        <translation>Φύλαξη δεδομένων</translation>
    </message>
    <message>
        <source>The database uses %1; %2 is free.</source>
        <translation>Η βάση δεδομένων έχει μέγεθος %1· ελεύθερα %2.</translation>
    </message>
    <message>
        <source>Open storage</source>
        <translation>Άνοιγμα φύλαξης δεδομένων</translation>
    </message>
    <message>
        <source>The last session ran with real-time priority.</source>
        <translation>Η τελευταία συνεδρία έτρεξε με προτεραιότητα πραγματικού χρόνου.</translation>
    </message>
    <message>
        <source>The last session ran without real-time priority: forces may feel less smooth.</source>
        <translation>Η τελευταία συνεδρία έτρεξε χωρίς προτεραιότητα πραγματικού χρόνου: η αίσθηση της δύναμης ίσως είναι λιγότερο ομαλή.</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Σταθμός</translation>
    </message>
    <message>
        <source>Devices, timing of the force loop, free space for recordings.</source>
        <translation>Συσκευές, χρονισμός του βρόχου δύναμης, ελεύθερος χώρος για καταγραφές.</translation>
    </message>
    <message>
        <source>Open the station check</source>
        <translation>Άνοιγμα ελέγχου σταθμού</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Αρχική</translation>
    </message>
    <message>
        <source>Finding your next step …</source>
        <translation>Αναζήτηση επόμενου βήματος …</translation>
    </message>
    <message>
        <source>The home screen could not be loaded.</source>
        <translation>Δεν ήταν δυνατή η φόρτωση της αρχικής οθόνης.</translation>
    </message>
    <message>
        <source>Welcome, %1</source>
        <translation>Καλωσορίσατε, %1</translation>
    </message>
    <message numerus="yes">
        <source>The program ended unexpectedly during session %1 (%2, %3). The session was saved as interrupted: %n sample(s) were kept and can be played back. The session does not count.</source>
        <translation>
            <numerusform>Το πρόγραμμα έκλεισε απρόσμενα στη συνεδρία %1 (%2, %3). Η συνεδρία αποθηκεύτηκε ως «Διακόπηκε»: %n δείγμα διατηρείται και μπορεί να αναπαραχθεί. Η συνεδρία δεν μετράει.</numerusform>
            <numerusform>Το πρόγραμμα έκλεισε απρόσμενα στη συνεδρία %1 (%2, %3). Η συνεδρία αποθηκεύτηκε ως «Διακόπηκε»: %n δείγματα διατηρούνται και μπορούν να αναπαραχθούν. Η συνεδρία δεν μετράει.</numerusform>
        </translation>
    </message>
    <message>
        <source>The program ended unexpectedly during session %1 (%2, %3). The session could not be fully recovered: %4</source>
        <translation>Το πρόγραμμα έκλεισε απρόσμενα στη συνεδρία %1 (%2, %3). Η συνεδρία δεν ανακτήθηκε ολόκληρη: %4</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Προβολή</translation>
    </message>
    <message>
        <source>%1, level %2: %3</source>
        <translation>%1, επίπεδο %2: %3</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Μελέτες</translation>
    </message>
    <message>
        <source>Design a study or begin with a template, try it with simulated observers, freeze it, enrol participants.</source>
        <translation>Σχεδιάστε μια μελέτη ή αρχίστε από πρότυπο, δοκιμάστε τη με προσομοιωμένους παρατηρητές, οριστικοποιήστε τη, εγγράψτε συμμετέχοντες.</translation>
    </message>
    <message>
        <source>Open the studies</source>
        <translation>Άνοιγμα μελετών</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Διεξαγωγή</translation>
    </message>
    <message>
        <source>Guide a participant through a study by code, in the order set for them. Interrupted runs continue where they stopped.</source>
        <translation>Οδηγήστε έναν συμμετέχοντα σε μια μελέτη με τον κωδικό του και με τη σειρά που του έχει οριστεί. Όσες εκτελέσεις διακόπηκαν συνεχίζονται από εκεί που σταμάτησαν.</translation>
    </message>
    <message>
        <source>Run a study</source>
        <translation>Διεξαγωγή μελέτης</translation>
    </message>
    <message>
        <source>Curves, thresholds and intervals of each person and the group, every trial with its fidelity, exports.</source>
        <translation>Καμπύλες, κατώφλια και διαστήματα κάθε ατόμου και της ομάδας, κάθε δοκιμή με την πιστότητά της, εξαγωγές.</translation>
    </message>
    <message>
        <source>Training sessions</source>
        <translation>Συνεδρίες εκπαίδευσης</translation>
    </message>
    <message>
        <source>Open the sessions</source>
        <translation>Άνοιγμα συνεδριών</translation>
    </message>
    <message>
        <source>Choose another exercise</source>
        <translation>Επιλογή άλλης άσκησης</translation>
    </message>
    <message>
        <source>Well done. Choose any exercise to stay in practice.</source>
        <translation>Μπράβο. Επιλέξτε οποιαδήποτε άσκηση για να μείνετε σε φόρμα.</translation>
    </message>
    <message>
        <source>Somebody</source>
        <translation>Κάποιος</translation>
    </message>
    <message>
        <source>%1 commented on your session %2 (%3, level %4).</source>
        <translation>%1 σχολίασε τη συνεδρία σας %2 (%3, επίπεδο %4).</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Ανάγνωση</translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) withdrew from a study and asked for their recordings to be erased. Under People, choose &quot;Erase a participant&quot;.</source>
        <translation>
            <numerusform>%n συμμετέχων αποσύρθηκε από μελέτη και ζήτησε να διαγραφούν οι καταγραφές του. Στα Άτομα επιλέξτε «Διαγραφή συμμετέχοντα».</numerusform>
            <numerusform>%n συμμετέχοντες αποσύρθηκαν από μελέτη και ζήτησαν να διαγραφούν οι καταγραφές τους. Στα Άτομα επιλέξτε «Διαγραφή συμμετέχοντα».</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. %2. Opens the results.</source>
        <translation>%1. %2. Ανοίγει τα αποτελέσματα.</translation>
    </message>
    <message>
        <source>You are an administrator and have no recovery code yet. With one, you can set a new password yourself if you forget yours.</source>
        <translation>Είστε διαχειριστής/-τρια και δεν έχετε ακόμη κωδικό ανάκτησης. Με αυτόν ορίζετε μόνοι σας νέο κωδικό πρόσβασης αν ξεχάσετε τον δικό σας.</translation>
    </message>
    <message>
        <source>Make one …</source>
        <translation>Δημιουργία …</translation>
    </message>
    <message>
        <source>Try an exercise yourself</source>
        <translation>Δοκιμάστε μόνοι σας μια άσκηση</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>It takes about a minute with mouse and keyboard, does not count, and ends with a debrief.</source>
        <translation>Διαρκεί περίπου ένα λεπτό με ποντίκι και πληκτρολόγιο, δεν μετράει και τελειώνει με απολογισμό.</translation>
    </message>
    <message>
        <source>Try it now</source>
        <translation>Δοκιμή τώρα</translation>
    </message>
    <message>
        <source>A few trials that do not count, with mouse and keyboard.</source>
        <translation>Λίγες δοκιμές με ποντίκι και πληκτρολόγιο, που δεν μετρούν.</translation>
    </message>
    <message>
        <source>Your next step, depending on your role.

If you have not trained yet, you can try an exercise here in about a minute. Trainees continue with the next level at the press of a button, choose any level from the exercises, and see their latest results. Trainers see the sessions that need a review, interrupted or failed ones first, and who trained recently. Administrators see whether people, storage and station are in order.

The list on the left leads to all other screens; Ctrl+K finds any command by its name.</source>
        <translation>Το επόμενο βήμα σας, ανάλογα με τον ρόλο σας.

Αν δεν έχετε εκπαιδευτεί ακόμη, μπορείτε να δοκιμάσετε εδώ μια άσκηση σε περίπου ένα λεπτό. Οι εκπαιδευόμενοι συνεχίζουν με ένα κουμπί στο επόμενο επίπεδο, επιλέγουν οποιοδήποτε επίπεδο από τις ασκήσεις και βλέπουν τα τελευταία τους αποτελέσματα. Οι εκπαιδευτές βλέπουν τις συνεδρίες που χρειάζονται αξιολόγηση, πρώτα όσες διακόπηκαν ή δεν πέτυχαν, και ποιοι εκπαιδεύτηκαν πρόσφατα. Οι διαχειριστές βλέπουν αν άτομα, δεδομένα και σταθμός είναι εντάξει.

Η λίστα αριστερά οδηγεί σε όλες τις άλλες οθόνες· το Ctrl+K βρίσκει κάθε εντολή με το όνομά της.</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) to review</source>
        <translation>
            <numerusform>%n συνεδρία προς αξιολόγηση</numerusform>
            <numerusform>%n συνεδρίες προς αξιολόγηση</numerusform>
        </translation>
    </message>
    <message>
        <source>List of sessions to review</source>
        <translation>Λίστα συνεδριών προς αξιολόγηση</translation>
    </message>
    <message numerus="yes">
        <source>Comments: unread on %n session(s)</source>
        <translation>
            <numerusform>Σχόλια: αδιάβαστα σε %n συνεδρία</numerusform>
            <numerusform>Σχόλια: αδιάβαστα σε %n συνεδρίες</numerusform>
        </translation>
    </message>
    <message>
        <source>Comments, received and written</source>
        <translation>Σχόλια που λάβατε και που γράψατε</translation>
    </message>
    <message>
        <source>%1 answered your comment on session %2 (%3, level %4).</source>
        <translation>%1 απάντησε στο σχόλιό σας για τη συνεδρία %2 (%3, επίπεδο %4).</translation>
    </message>
    <message>
        <source>Progress of the group</source>
        <translation>Πρόοδος της ομάδας</translation>
    </message>
    <message>
        <source>Everything is reviewed. A trainee&apos;s latest attempt at each level will appear here.</source>
        <translation>Όλα έχουν αξιολογηθεί. Εδώ θα εμφανίζεται η τελευταία προσπάθεια του εκπαιδευομένου σε κάθε επίπεδο.</translation>
    </message>
    <message>
        <source>Last time: level %1 · %2 · %3</source>
        <translation>Τελευταία φορά: επίπεδο %1 · %2 · %3</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::InfoPanel</name>
    <message>
        <source>Elapsed: %1</source>
        <translation>Χρόνος: %1</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Δύναμη</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Ροπή</translation>
    </message>
    <message>
        <source>mN·m</source>
        <translation>mN·m</translation>
    </message>
    <message>
        <source>up</source>
        <translation>πάνω</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Δύναμη (N)</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Ταχύτητα (mm/s)</translation>
    </message>
    <message numerus="yes">
        <source>%n samples could not be recorded: this session will be incomplete.</source>
        <translation>
            <numerusform>%n δείγμα δεν καταγράφηκε: αυτή η συνεδρία θα είναι ελλιπής.</numerusform>
            <numerusform>%n δείγματα δεν καταγράφηκαν: αυτή η συνεδρία θα είναι ελλιπής.</numerusform>
        </translation>
    </message>
    <message>
        <source>Tip of the tool (mm)</source>
        <translation>Άκρη εργαλείου (mm)</translation>
    </message>
    <message>
        <source>right</source>
        <translation>δεξιά</translation>
    </message>
    <message>
        <source>away</source>
        <translation>εμπρός</translation>
    </message>
    <message>
        <source>Recording complete; nothing is lost. %1 % of the force updates came late.</source>
        <translation>Πλήρης καταγραφή· τίποτα δεν χάθηκε. Το %1 % των ενημερώσεων της δύναμης καθυστέρησε.</translation>
    </message>
    <message>
        <source>Recording complete; every force update on time</source>
        <translation>Πλήρης καταγραφή· καμία ενημέρωση της δύναμης δεν καθυστέρησε</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::InsertionPanel</name>
    <message>
        <source>Progress in this stage</source>
        <translation>Πρόοδος αυτού του σταδίου</translation>
    </message>
    <message>
        <source>Resistance along</source>
        <translation>Αντίσταση κατά μήκος</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>Πλάγια δύναμη</translation>
    </message>
    <message>
        <source>Fx</source>
        <translation>Fx</translation>
    </message>
    <message>
        <source>Force along x, to the side</source>
        <translation>Δύναμη κατά τον άξονα x, προς το πλάι</translation>
    </message>
    <message>
        <source>Fy</source>
        <translation>Fy</translation>
    </message>
    <message>
        <source>Force along y, upwards</source>
        <translation>Δύναμη κατά τον άξονα y, προς τα πάνω</translation>
    </message>
    <message>
        <source>Fz</source>
        <translation>Fz</translation>
    </message>
    <message>
        <source>Force along z, into the patient</source>
        <translation>Δύναμη κατά τον άξονα z, προς τον ασθενή</translation>
    </message>
    <message>
        <source>Tx</source>
        <translation>Tx</translation>
    </message>
    <message>
        <source>Torque about x</source>
        <translation>Ροπή ως προς τον άξονα x</translation>
    </message>
    <message>
        <source>mN·m</source>
        <translation>mN·m</translation>
    </message>
    <message>
        <source>Ty</source>
        <translation>Ty</translation>
    </message>
    <message>
        <source>Torque about y</source>
        <translation>Ροπή ως προς τον άξονα y</translation>
    </message>
    <message>
        <source>Tz</source>
        <translation>Tz</translation>
    </message>
    <message>
        <source>Torque about the endoscope&apos;s axis</source>
        <translation>Ροπή ως προς τον άξονα του ενδοσκοπίου</translation>
    </message>
    <message>
        <source>Tip x (mm)</source>
        <translation>Άκρη x (mm)</translation>
    </message>
    <message>
        <source>Tip y (mm)</source>
        <translation>Άκρη y (mm)</translation>
    </message>
    <message>
        <source>Tip z (mm)</source>
        <translation>Άκρη z (mm)</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Βάθος (mm)</translation>
    </message>
    <message>
        <source>Off-centre (mm)</source>
        <translation>Απόκλιση (mm)</translation>
    </message>
    <message>
        <source>Alignment (°)</source>
        <translation>Ευθυγράμμιση (°)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Δύναμη (N)</translation>
    </message>
    <message>
        <source>Force across (N)</source>
        <translation>Πλάγια δύναμη (N)</translation>
    </message>
    <message>
        <source>Forces (N) and torques (mN·m) on the endoscope</source>
        <translation>Δυνάμεις (N) και ροπές (mN·m) στο ενδοσκόπιο</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::KeyTableDialog</name>
    <message>
        <source>Who is who</source>
        <translation>Ποιος είναι ποιος</translation>
    </message>
    <message>
        <source>Opening this table is recorded in the audit trail.</source>
        <translation>Το άνοιγμα αυτού του πίνακα καταγράφεται στο ημερολόγιο ελέγχου.</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Κωδικός</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>Ταυτότητα</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Κλείσιμο</translation>
    </message>
    <message>
        <source>Reading the key table …</source>
        <translation>Ανάγνωση του πίνακα κλειδιών …</translation>
    </message>
    <message>
        <source>The key table could not be read</source>
        <translation>Ο πίνακας κλειδιών δεν διαβάστηκε</translation>
    </message>
    <message>
        <source>The key table is empty</source>
        <translation>Ο πίνακας κλειδιών είναι άδειος</translation>
    </message>
    <message>
        <source>Simulated participants have no key.</source>
        <translation>Οι προσομοιωμένοι συμμετέχοντες δεν έχουν κλειδί.</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Όνομα χρήστη</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LatenessChart</name>
    <message>
        <source>Lateness of the force loop</source>
        <translation>Καθυστέρηση του βρόχου δύναμης</translation>
    </message>
    <message>
        <source>over %1 µs</source>
        <translation>πάνω από %1 µs</translation>
    </message>
    <message>
        <source>up to %1 µs</source>
        <translation>έως %1 µs</translation>
    </message>
    <message>
        <source>%1 %, late</source>
        <translation>%1 %, με καθυστέρηση</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LeanDial</name>
    <message>
        <source>Tilt of the fingertip platform</source>
        <translation>Κλίση της πλατφόρμας δακτύλου</translation>
    </message>
    <message>
        <source>%1°, at its limit</source>
        <translation>%1°, στο όριο</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Κλίση</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LevelChooser</name>
    <message>
        <source>Level %1: %2</source>
        <translation>Επίπεδο %1: %2</translation>
    </message>
    <message>
        <source>Not tried yet</source>
        <translation>Καμία προσπάθεια ακόμη</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Επιτυχία</translation>
    </message>
    <message numerus="yes">
        <source>Tried %n times, not passed yet</source>
        <translation>
            <numerusform>%n προσπάθεια, χωρίς επιτυχία ακόμη</numerusform>
            <numerusform>%n προσπάθειες, χωρίς επιτυχία ακόμη</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · recommended next</source>
        <translation>%1 · προτείνεται τώρα</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LevelsTable</name>
    <message>
        <source>Object</source>
        <translation>Αντικείμενο</translation>
    </message>
    <message>
        <source>Differences from the reference in per cent</source>
        <translation>Διαφορές από την αναφορά επί τοις εκατό</translation>
    </message>
    <message>
        <source>Paste numbers</source>
        <translation>Επικόλληση αριθμών</translation>
    </message>
    <message>
        <source>Add a row</source>
        <translation>Προσθήκη γραμμής</translation>
    </message>
    <message>
        <source>Remove the row</source>
        <translation>Αφαίρεση γραμμής</translation>
    </message>
    <message>
        <source>There are no numbers to paste. Copy them first.</source>
        <translation>Δεν υπάρχουν αριθμοί για επικόλληση. Αντιγράψτε τους πρώτα.</translation>
    </message>
    <message>
        <source>Difference (%)</source>
        <translation>Διαφορά (%)</translation>
    </message>
    <message>
        <source>A row is empty. Type a number into it, or remove the row.</source>
        <translation>Μια γραμμή είναι κενή. Πληκτρολογήστε αριθμό ή αφαιρέστε τη γραμμή.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LivePlot</name>
    <message>
        <source>The last %1 seconds</source>
        <translation>Τα τελευταία %1 δευτερόλεπτα</translation>
    </message>
    <message>
        <source>-%1 s</source>
        <translation>-%1 s</translation>
    </message>
    <message>
        <source>now</source>
        <translation>τώρα</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>όριο</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LockController</name>
    <message>
        <source>Locked - Chiron</source>
        <translation>Κλειδωμένο - Chiron</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LockCover</name>
    <message>
        <source>Locked</source>
        <translation>Κλειδωμένο</translation>
    </message>
    <message>
        <source>%1 is logged in. Everything keeps running and nothing is lost; only the screen is covered.</source>
        <translation>Σε σύνδεση: %1. Όλα συνεχίζονται και διατηρούνται· η οθόνη απλώς καλύφθηκε.</translation>
    </message>
    <message>
        <source>Password of %1</source>
        <translation>Κωδικός πρόσβασης για %1</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Ξεκλείδωμα</translation>
    </message>
    <message>
        <source>Switch user</source>
        <translation>Αλλαγή χρήστη</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Έλεγχος …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LoginForm</name>
    <message>
        <source>Password</source>
        <translation>Κωδικός πρόσβασης</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Σύνδεση</translation>
    </message>
    <message>
        <source>Forgot your password?</source>
        <translation>Ξεχάσατε τον κωδικό;</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Έλεγχος …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LoginNameField</name>
    <message>
        <source>Login name</source>
        <translation>Όνομα χρήστη</translation>
    </message>
    <message>
        <source>Somebody has this login name already. Names that differ only in capital letters count as the same.</source>
        <translation>Αυτό το όνομα χρήστη υπάρχει ήδη. Ονόματα που διαφέρουν μόνο στα κεφαλαία θεωρούνται ίδια.</translation>
    </message>
    <message>
        <source>No commas.</source>
        <translation>Χωρίς κόμματα.</translation>
    </message>
    <message>
        <source>A login name is needed. No commas.</source>
        <translation>Χρειάζεται όνομα χρήστη. Χωρίς κόμματα.</translation>
    </message>
    <message>
        <source>This name cannot be used. Use at most %1 characters, no commas and no spaces at the ends. Some names are reserved for the program.</source>
        <translation>Αυτό το όνομα δεν επιτρέπεται. Χρησιμοποιήστε το πολύ %1 χαρακτήρες, χωρίς κόμματα και χωρίς κενά στα άκρα. Ορισμένα ονόματα είναι δεσμευμένα από το πρόγραμμα.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LoginScreen</name>
    <message>
        <source>Opening the site …</source>
        <translation>Άνοιγμα του κέντρου …</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Σύνδεση</translation>
    </message>
    <message>
        <source>The site could not be opened.</source>
        <translation>Δεν ήταν δυνατό το άνοιγμα του κέντρου.</translation>
    </message>
    <message>
        <source>The list of names could not be read.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση των ονομάτων.</translation>
    </message>
    <message>
        <source>This is a demonstration: choose anyone. The password for everyone is %1</source>
        <translation>Πρόκειται για επίδειξη: επιλέξτε οποιονδήποτε. Ο κωδικός πρόσβασης για όλους είναι %1</translation>
    </message>
    <message>
        <source>This is the password that you were given. Choose another one.</source>
        <translation>Αυτός είναι ο κωδικός που σας δόθηκε. Επιλέξτε άλλον.</translation>
    </message>
    <message>
        <source>The password was not changed.
%1</source>
        <translation>Ο κωδικός πρόσβασης δεν άλλαξε.
%1</translation>
    </message>
    <message>
        <source>Checking the site&apos;s file …</source>
        <translation>Έλεγχος του αρχείου του κέντρου …</translation>
    </message>
    <message>
        <source>Type a few letters of your name, or choose it in the list, then enter your password.

After three wrong passwords the account is locked for a short time; the button counts down the seconds. No data are lost.

Forgot your password? An administrator can give you a new one. Administrators can use their recovery code.</source>
        <translation>Πληκτρολογήστε μερικά γράμματα του ονόματός σας ή επιλέξτε το στη λίστα και δώστε τον κωδικό πρόσβασης.

Μετά από τρεις λανθασμένους κωδικούς ο λογαριασμός κλειδώνει για λίγο· το κουμπί μετρά αντίστροφα τα δευτερόλεπτα. Δεν χάνονται δεδομένα.

Ξεχάσατε τον κωδικό; Ένας διαχειριστής μπορεί να σας δώσει νέο. Οι διαχειριστές μπορούν να χρησιμοποιήσουν τον κωδικό ανάκτησής τους.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::MainWindow</name>
    <message>
        <source>Demonstration site: invented people and scripted sessions. Do not record real training here.</source>
        <translation>Κέντρο επίδειξης: φανταστικά άτομα και προσομοιωμένες συνεδρίες. Μην καταγράφετε εδώ πραγματική εκπαίδευση.</translation>
    </message>
    <message>
        <source>%1 - Chiron</source>
        <translation>%1 - Chiron</translation>
    </message>
    <message>
        <source>F1: help with this screen · Ctrl+K: find a screen, command, person, session or study</source>
        <translation>F1: βοήθεια για αυτή την οθόνη · Ctrl+K: εύρεση οθόνης, εντολής, προσώπου, συνεδρίας ή μελέτης</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::MarkList</name>
    <message>
        <source>Penalties only</source>
        <translation>Μόνο ποινές</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Συμβάντα</translation>
    </message>
    <message>
        <source>No events of this kind.</source>
        <translation>Δεν υπάρχουν τέτοια συμβάντα.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Include contacts</source>
        <translation>Και επαφές</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Κλείσιμο του μηνύματος</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Όλο το μήνυμα</translation>
    </message>
    <message>
        <source>The whole message</source>
        <translation>Ολόκληρο το μήνυμα</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::MetricsTable</name>
    <message>
        <source>All metrics</source>
        <translation>Όλες οι μετρήσεις</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Μέτρηση</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Τιμή</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Όριο επιτυχίας</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Αποτέλεσμα</translation>
    </message>
    <message>
        <source>Met</source>
        <translation>Εντός ορίου</translation>
    </message>
    <message>
        <source>Not met</source>
        <translation>Εκτός ορίου</translation>
    </message>
    <message>
        <source>Benchmark, chance</source>
        <translation>Αναφορά, τύχη</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::NameList</name>
    <message>
        <source>Name</source>
        <translation>Όνομα</translation>
    </message>
    <message>
        <source>Type your name, or choose it below</source>
        <translation>Πληκτρολογήστε ή επιλέξτε το όνομά σας</translation>
    </message>
    <message>
        <source>People who can log in</source>
        <translation>Άτομα που μπορούν να συνδεθούν</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Nobody with this name can log in here. Ask an administrator; your login name may have changed.</source>
        <translation>Κανείς με αυτό το όνομα δεν μπορεί να συνδεθεί εδώ. Ρωτήστε έναν διαχειριστή· το όνομα χρήστη σας μπορεί να έχει αλλάξει.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::NewPasswordPage</name>
    <message>
        <source>Choose a password of your own</source>
        <translation>Επιλέξτε δικό σας κωδικό πρόσβασης</translation>
    </message>
    <message>
        <source>Your current password was set by someone else. From your next login, only the new one is valid.</source>
        <translation>Ο τωρινός κωδικός ορίστηκε από άλλο άτομο. Από την επόμενη σύνδεση ισχύει μόνο ο νέος.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Πίσω</translation>
    </message>
    <message>
        <source>Save and log in</source>
        <translation>Αποθήκευση και σύνδεση</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Αποθήκευση …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::NewStudyDialog</name>
    <message>
        <source>New study</source>
        <translation>Νέα μελέτη</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>Αρχή από</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Τίτλος</translation>
    </message>
    <message>
        <source>Key (in files and commands)</source>
        <translation>Κλειδί (σε αρχεία και εντολές)</translation>
    </message>
    <message>
        <source>Lower-case letters, digits and _ only. It cannot be changed later.</source>
        <translation>Μόνο πεζά λατινικά, ψηφία και _. Δεν αλλάζει αργότερα.</translation>
    </message>
    <message>
        <source>Create draft</source>
        <translation>Δημιουργία πρόχειρου</translation>
    </message>
    <message>
        <source>The templates could not be read.
%1</source>
        <translation>Τα πρότυπα δεν διαβάστηκαν.
%1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>The study was not created. Its key may already be in use.
%1</source>
        <translation>Η μελέτη δεν δημιουργήθηκε. Ίσως το κλειδί χρησιμοποιείται ήδη.
%1</translation>
    </message>
    <message>
        <source>Copy to a new study</source>
        <translation>Αντιγραφή σε νέα μελέτη</translation>
    </message>
    <message>
        <source>The copy is a draft with the whole design of “%1”, without its participants, data and ethics approval.</source>
        <translation>Το αντίγραφο είναι πρόχειρο με όλο το σχέδιο της μελέτης «%1», χωρίς συμμετέχοντες, δεδομένα και έγκριση δεοντολογίας.</translation>
    </message>
    <message>
        <source>Trials: %1</source>
        <translation>Δοκιμές: %1</translation>
    </message>
    <message>
        <source>Duration: %1</source>
        <translation>Διάρκεια: %1</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Κατά: %1</translation>
    </message>
    <message>
        <source>Give the study a title.</source>
        <translation>Δώστε στη μελέτη τίτλο.</translation>
    </message>
    <message>
        <source>Give the study a key.</source>
        <translation>Δώστε στη μελέτη κλειδί.</translation>
    </message>
    <message>
        <source>Use only lower-case letters, digits and _, and begin with a letter.</source>
        <translation>Χρησιμοποιήστε μόνο πεζά λατινικά γράμματα, ψηφία και _, με γράμμα στην αρχή.</translation>
    </message>
    <message>
        <source>Another study has this key. Choose another.</source>
        <translation>Μια άλλη μελέτη έχει αυτό το κλειδί. Επιλέξτε άλλο.</translation>
    </message>
    <message>
        <source>Each template is a complete design. Everything in it can be changed until the study is frozen.</source>
        <translation>Κάθε πρότυπο είναι ένα πλήρες σχέδιο. Όλα αλλάζουν μέχρι να οριστικοποιηθεί η μελέτη.</translation>
    </message>
    <message>
        <source>Find a template</source>
        <translation>Αναζήτηση προτύπου</translation>
    </message>
    <message>
        <source>No template matches “%1”. Try fewer or other words.</source>
        <translation>Κανένα πρότυπο δεν ταιριάζει με «%1». Δοκιμάστε λιγότερες ή άλλες λέξεις.</translation>
    </message>
    <message>
        <source>Another study has this title, and the two could not be told apart in lists. Choose another title.</source>
        <translation>Μια άλλη μελέτη έχει αυτόν τον τίτλο και στις λίστες οι δύο δεν θα ξεχώριζαν. Επιλέξτε άλλον τίτλο.</translation>
    </message>
    <message>
        <source>A simple study: %1</source>
        <translation>Μια απλή μελέτη: %1</translation>
    </message>
    <message>
        <source>One condition, stiffness. %1</source>
        <translation>Μία συνθήκη, δυσκαμψία. %1</translation>
    </message>
    <message>
        <source>For example: 2AFC, weight, two conditions, Watson</source>
        <translation>Για παράδειγμα: 2AFC, βάρος, δύο συνθήκες, Watson</translation>
    </message>
    <message>
        <source>Conditions: %1</source>
        <translation>Συνθήκες: %1</translation>
    </message>
    <message>
        <source>The templates are being read.</source>
        <translation>Τα πρότυπα διαβάζονται.</translation>
    </message>
    <message>
        <source>Choose what to begin with first.</source>
        <translation>Επιλέξτε πρώτα από τι θα ξεκινήσετε.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PaletteFinder</name>
    <message>
        <source>People</source>
        <translation>Άτομα</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Ασκήσεις</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Συνεδρίες</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Μελέτες</translation>
    </message>
    <message>
        <source>Searching people, sessions and studies …</source>
        <translation>Αναζήτηση σε άτομα, συνεδρίες και μελέτες …</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>On other screens</source>
        <translation>Σε άλλες οθόνες</translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n more; type more letters)</source>
        <translation>
            <numerusform>%1 (%n ακόμη· γράψτε περισσότερα γράμματα)</numerusform>
            <numerusform>%1 (%n ακόμη· γράψτε περισσότερα γράμματα)</numerusform>
        </translation>
    </message>
    <message>
        <source>Not everything could be searched: %1</source>
        <translation>Δεν ήταν δυνατή η αναζήτηση παντού: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PalpationBox</name>
    <message>
        <source>Trial</source>
        <translation>Δοκιμή</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>Δοκιμή %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PalpationPanel</name>
    <message>
        <source>%1: force</source>
        <translation>%1: δύναμη</translation>
    </message>
    <message>
        <source>%1: squeeze of the jaw</source>
        <translation>%1: σύσφιξη των σιαγόνων</translation>
    </message>
    <message>
        <source>Squeeze of the jaw</source>
        <translation>Σύσφιξη των σιαγόνων</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force map (M)</source>
        <translation>Χάρτης δύναμης (M)</translation>
    </message>
    <message>
        <source>On: the map shows how hard the tissue was pressed. Off: it shows where the tissue was searched.</source>
        <translation>Ναι: ο χάρτης δείχνει πόσο δυνατά πιέστηκε ο ιστός. Όχι: δείχνει πού ερευνήθηκε.</translation>
    </message>
    <message>
        <source>rendered force (N)</source>
        <translation>αποδιδόμενη δύναμη (N)</translation>
    </message>
    <message>
        <source>tilt (°)</source>
        <translation>κλίση (°)</translation>
    </message>
    <message>
        <source>depth (mm)</source>
        <translation>βάθος (mm)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Force, first finger (N)</source>
        <translation>Δύναμη, πρώτο δάκτυλο (N)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Δύναμη (N)</translation>
    </message>
    <message>
        <source>Tilt, first finger (°)</source>
        <translation>Κλίση, πρώτο δάκτυλο (°)</translation>
    </message>
    <message>
        <source>Tilt (°)</source>
        <translation>Κλίση (°)</translation>
    </message>
    <message>
        <source>Searched: %1 %</source>
        <translation>Ερευνήθηκε: %1 %</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ParticipantCard</name>
    <message>
        <source>What a participant will meet</source>
        <translation>Τι θα συναντήσει κάθε συμμετέχων</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ParticipantWindow</name>
    <message>
        <source>Study</source>
        <translation>Μελέτη</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ParticipantsPage</name>
    <message>
        <source>Participants can be enrolled once the design is frozen.</source>
        <translation>Συμμετέχοντες εγγράφονται αφού οριστικοποιηθεί το σχέδιο.</translation>
    </message>
    <message>
        <source>Nobody is enrolled yet. Each participant gets a random code; the identity is kept in a separate key table.</source>
        <translation>Κανείς δεν έχει εγγραφεί ακόμη. Κάθε συμμετέχων παίρνει τυχαίο κωδικό· η ταυτότητά του φυλάσσεται σε ξεχωριστό πίνακα κλειδιών.</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Συμμετέχοντες</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Κωδικός</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Κατάσταση</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Συνθήκες</translation>
    </message>
    <message>
        <source>Enrolled</source>
        <translation>Εγγραφή</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Συγκατάθεση</translation>
    </message>
    <message>
        <source>Enrol …</source>
        <translation>Εγγραφή …</translation>
    </message>
    <message>
        <source>Consent …</source>
        <translation>Συγκατάθεση …</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Διεξαγωγή</translation>
    </message>
    <message>
        <source>Withdraw …</source>
        <translation>Απόσυρση …</translation>
    </message>
    <message>
        <source>Who is who …</source>
        <translation>Ποιος είναι ποιος …</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1 (προσομοιωμένος)</translation>
    </message>
    <message>
        <source>Choose a participant in the list first.</source>
        <translation>Επιλέξτε πρώτα έναν συμμετέχοντα από τη λίστα.</translation>
    </message>
    <message>
        <source>This participant is simulated.</source>
        <translation>Ο συμμετέχων είναι προσομοιωμένος.</translation>
    </message>
    <message>
        <source>This participant has withdrawn.</source>
        <translation>Ο συμμετέχων έχει αποσυρθεί.</translation>
    </message>
    <message>
        <source>This participant has done every run.</source>
        <translation>Ο συμμετέχων ολοκλήρωσε όλες τις εκτελέσεις.</translation>
    </message>
    <message>
        <source>Participants can be enrolled only while the study is frozen.</source>
        <translation>Συμμετέχοντες εγγράφονται μόνο όσο η μελέτη είναι οριστικοποιημένη.</translation>
    </message>
    <message>
        <source>The consent is recorded already.</source>
        <translation>Η συγκατάθεση έχει ήδη καταγραφεί.</translation>
    </message>
    <message>
        <source>Record the consent first.</source>
        <translation>Καταγράψτε πρώτα τη συγκατάθεση.</translation>
    </message>
    <message>
        <source>Nobody is enrolled yet.</source>
        <translation>Δεν έχει εγγραφεί ακόμη κανείς.</translation>
    </message>
    <message>
        <source>%1. %2: %3.</source>
        <translation>%1. %2: %3.</translation>
    </message>
    <message>
        <source>Design row</source>
        <translation>Γραμμή σχεδίου</translation>
    </message>
    <message>
        <source>The row of the order design (%1), counted from 1: it says in which order this participant does the conditions. Whoever is enrolled gets the next free row, and the row of somebody who withdraws becomes free again, so the rows need not follow the order of enrolment.</source>
        <translation>Η γραμμή του σχεδίου σειράς (%1), με αρίθμηση από το 1: δείχνει με ποια σειρά κάνει τις συνθήκες αυτός ο συμμετέχων. Όποιος εγγράφεται παίρνει την επόμενη ελεύθερη γραμμή, και η γραμμή όποιου αποσύρεται ελευθερώνεται ξανά, οπότε οι γραμμές δεν ακολουθούν απαραίτητα τη σειρά εγγραφής.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PasswordChoice</name>
    <message>
        <source>Initial password</source>
        <translation>Αρχικός κωδικός πρόσβασης</translation>
    </message>
    <message>
        <source>Generate one (shown once)</source>
        <translation>Αυτόματη δημιουργία (εμφανίζεται μία φορά)</translation>
    </message>
    <message>
        <source>Type one</source>
        <translation>Πληκτρολόγηση</translation>
    </message>
    <message>
        <source>It has to be changed at the next login, so that only its owner knows it.</source>
        <translation>Πρέπει να αλλάξει στην επόμενη σύνδεση, ώστε να τον γνωρίζει μόνο ο κάτοχός του.</translation>
    </message>
    <message>
        <source>Hand this password to %1. It is shown only now and has to be changed at the next login.</source>
        <translation>Κωδικός πρόσβασης για %1: παραδώστε τον. Εμφανίζεται μόνο τώρα και πρέπει να αλλάξει στην επόμενη σύνδεση.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Αντιγραφή</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Αντιγράφηκε</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PasswordFields</name>
    <message>
        <source>New password</source>
        <translation>Νέος κωδικός πρόσβασης</translation>
    </message>
    <message>
        <source>Repeat the password</source>
        <translation>Επανάληψη κωδικού πρόσβασης</translation>
    </message>
    <message>
        <source>Show the password</source>
        <translation>Εμφάνιση κωδικού</translation>
    </message>
    <message>
        <source>Length: %1 characters or more</source>
        <translation>Μήκος: τουλάχιστον %1 χαρακτήρες</translation>
    </message>
    <message>
        <source>Variety: %1 different characters or more</source>
        <translation>Ποικιλία: τουλάχιστον %1 διαφορετικοί χαρακτήρες</translation>
    </message>
    <message>
        <source>Not the login name</source>
        <translation>Όχι το όνομα χρήστη</translation>
    </message>
    <message>
        <source>Both fields are the same</source>
        <translation>Τα δύο πεδία είναι ίδια</translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Εντάξει: %1</translation>
    </message>
    <message>
        <source>Still missing: %1</source>
        <translation>Λείπει ακόμη: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PeopleModel</name>
    <message>
        <source>Disabled</source>
        <translation>Απενεργοποιημένος</translation>
    </message>
    <message>
        <source>Must change the password</source>
        <translation>Απαιτείται αλλαγή κωδικού</translation>
    </message>
    <message>
        <source>Can log in</source>
        <translation>Μπορεί να συνδεθεί</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Όνομα χρήστη</translation>
    </message>
    <message>
        <source>Full name</source>
        <translation>Πλήρες όνομα</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Ρόλοι</translation>
    </message>
    <message>
        <source>Account</source>
        <translation>Λογαριασμός</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PeopleScreen</name>
    <message>
        <source>Add a person</source>
        <translation>Προσθήκη ατόμου</translation>
    </message>
    <message>
        <source>Import roster</source>
        <translation>Εισαγωγή λίστας</translation>
    </message>
    <message>
        <source>Find a person</source>
        <translation>Εύρεση ατόμου</translation>
    </message>
    <message>
        <source>Choose a person in the list first.</source>
        <translation>Επιλέξτε πρώτα ένα άτομο στη λίστα.</translation>
    </message>
    <message>
        <source>Change roles</source>
        <translation>Αλλαγή ρόλων</translation>
    </message>
    <message>
        <source>Reset password</source>
        <translation>Επαναφορά κωδικού</translation>
    </message>
    <message>
        <source>Disable or enable</source>
        <translation>Απενεργοποίηση ή ενεργοποίηση</translation>
    </message>
    <message>
        <source>Export all data</source>
        <translation>Εξαγωγή όλων των στοιχείων</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Διαγραφή στοιχείων</translation>
    </message>
    <message>
        <source>%1 can log in again.</source>
        <translation>Μπορεί να συνδεθεί ξανά: %1.</translation>
    </message>
    <message>
        <source>%1 can no longer log in. Recorded data are kept.</source>
        <translation>Δεν μπορεί πλέον να συνδεθεί: %1. Όσα καταγράφηκαν διατηρούνται.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Αναίρεση</translation>
    </message>
    <message>
        <source>%1 stays enabled: the site needs at least one administrator who can log in. Make another person an administrator first.</source>
        <translation>Ο λογαριασμός μένει ενεργός: %1. Το κέντρο χρειάζεται τουλάχιστον έναν διαχειριστή που μπορεί να συνδεθεί. Ορίστε πρώτα άλλο άτομο ως διαχειριστή.</translation>
    </message>
    <message>
        <source>The account of %1 was not changed.</source>
        <translation>Ο λογαριασμός δεν άλλαξε: %1.</translation>
    </message>
    <message>
        <source>Export all data about %1</source>
        <translation>Εξαγωγή όλων των στοιχείων: %1</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>All data about %1 were exported to %2.</source>
        <translation>Έγινε εξαγωγή όλων των στοιχείων για %1 στο %2.</translation>
    </message>
    <message>
        <source>Nothing was exported about %1.</source>
        <translation>Δεν έγινε εξαγωγή για %1.</translation>
    </message>
    <message>
        <source>Import people from a CSV file</source>
        <translation>Εισαγωγή ατόμων από αρχείο CSV</translation>
    </message>
    <message>
        <source>CSV (*.csv);;All files (*)</source>
        <translation>CSV (*.csv);;Όλα τα αρχεία (*)</translation>
    </message>
    <message>
        <source>%1 cannot be read, or is too large for a list of people. Nothing was changed.</source>
        <translation>Το %1 δεν διαβάζεται ή είναι πολύ μεγάλο για λίστα ατόμων. Τίποτα δεν άλλαξε.</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Άτομα</translation>
    </message>
    <message>
        <source>Reading the list of people …</source>
        <translation>Ανάγνωση της λίστας ατόμων …</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>Απενεργοποίηση</translation>
    </message>
    <message>
        <source>The list of people could not be read.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση της λίστας ατόμων.</translation>
    </message>
    <message>
        <source>Nobody is chosen</source>
        <translation>Κανένα επιλεγμένο άτομο</translation>
    </message>
    <message>
        <source>Choose a person in the list to change or export something.</source>
        <translation>Επιλέξτε ένα άτομο στη λίστα για αλλαγή ή εξαγωγή.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Code %1: what researchers see in place of the name.</source>
        <translation>Ψευδώνυμο %1: αυτό βλέπουν οι ερευνητές αντί για το όνομα.</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>Ενεργοποίηση</translation>
    </message>
    <message>
        <source>Save a template for a roster</source>
        <translation>Αποθήκευση προτύπου λίστας</translation>
    </message>
    <message>
        <source>Edit name and login name</source>
        <translation>Επεξεργασία ονόματος και ονόματος χρήστη</translation>
    </message>
    <message>
        <source>roster</source>
        <translation>lista</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>The template was saved to %1. Replace the example lines, save the file as CSV, then import it here.</source>
        <translation>Το πρότυπο αποθηκεύτηκε στο %1. Αντικαταστήστε τις γραμμές-παραδείγματα, αποθηκεύστε το αρχείο ως CSV και μετά εισαγάγετέ το εδώ.</translation>
    </message>
    <message>
        <source>The template was not saved.</source>
        <translation>Το πρότυπο δεν αποθηκεύτηκε.</translation>
    </message>
    <message>
        <source>Save a template …</source>
        <translation>Αποθήκευση προτύπου …</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Επεξεργασία</translation>
    </message>
    <message>
        <source>Until %1: %2</source>
        <translation>Έως %1: %2</translation>
    </message>
    <message>
        <source>Erase a study participant</source>
        <translation>Διαγραφή στοιχείων συμμετέχοντα σε μελέτη</translation>
    </message>
    <message>
        <source>Everybody who has an account on this site.

Choose a person in the list, then an action below it. Changing roles and disabling take effect at once and can be undone. A person who gets a new password has to change it at the next login.

&quot;Edit&quot; changes a person&apos;s name or login name; the earlier ones stay in the history.

&quot;Import roster&quot; reads a CSV file as a spreadsheet saves it, with headings such as login name, full name and role (&quot;Save a template&quot; makes one), and first shows what will happen: either everything in the file is done, or nothing. Passwords are made for new people and can be printed as slips.

&quot;Export all data&quot; writes all data about a person to one file. &quot;Erase&quot; permanently removes a person&apos;s identity. &quot;Erase a participant&quot; does the same for somebody who has withdrawn from a study, even if they have no account.</source>
        <translation>Όλοι όσοι έχουν λογαριασμό σε αυτό το κέντρο.

Επιλέξτε ένα άτομο στη λίστα και μετά μια ενέργεια από κάτω. Η αλλαγή ρόλων και η απενεργοποίηση ισχύουν αμέσως και μπορούν να αναιρεθούν. Έναν νέο κωδικό πρόσβασης πρέπει να τον αλλάξει ο κάτοχός του στην επόμενη σύνδεση.

Η «Επεξεργασία» αλλάζει το όνομα ή το όνομα χρήστη ενός ατόμου· τα προηγούμενα μένουν στο ιστορικό.

Η «Εισαγωγή λίστας» διαβάζει ένα αρχείο CSV όπως το αποθηκεύει ένα πρόγραμμα υπολογιστικών φύλλων, με επικεφαλίδες όπως Όνομα χρήστη, Πλήρες όνομα και Ρόλος (η «Αποθήκευση προτύπου» φτιάχνει ένα τέτοιο), και δείχνει πρώτα τι θα κάνει: γίνονται όλα όσα γράφει το αρχείο ή τίποτα. Για τα νέα άτομα δημιουργούνται κωδικοί πρόσβασης, που τυπώνονται σε σημειώματα.

Η «Εξαγωγή όλων των στοιχείων» γράφει όλα τα στοιχεία ενός ατόμου σε ένα αρχείο. Η «Διαγραφή στοιχείων» σβήνει οριστικά την ταυτότητα του ατόμου. Η «Διαγραφή συμμετέχοντα» κάνει το ίδιο για όποιον αποσύρθηκε από μελέτη, ακόμη κι αν δεν έχει λογαριασμό.</translation>
    </message>
    <message>
        <source>Erase a participant …</source>
        <translation>Διαγραφή συμμετέχοντα …</translation>
    </message>
    <message>
        <source>No name and no role matches &quot;%1&quot;.</source>
        <translation>Κανένα όνομα και κανένας ρόλος δεν ταιριάζει με «%1».</translation>
    </message>
    <message>
        <source>Show everybody</source>
        <translation>Εμφάνιση όλων</translation>
    </message>
    <message>
        <source>Import roster …</source>
        <translation>Εισαγωγή λίστας …</translation>
    </message>
    <message>
        <source>Permanently removes the identity of somebody who took part in a study, even if they have no account here.</source>
        <translation>Αφαιρεί οριστικά την ταυτότητα κάποιου που συμμετείχε σε μελέτη, ακόμη κι αν δεν έχει λογαριασμό εδώ.</translation>
    </message>
    <message>
        <source>Permanently removes the identity of the person who is chosen in the list.</source>
        <translation>Αφαιρεί οριστικά την ταυτότητα του ατόμου που είναι επιλεγμένο στη λίστα.</translation>
    </message>
    <message>
        <source>Nobody was found</source>
        <translation>Δεν βρέθηκε κανείς</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PersonPage</name>
    <message>
        <source>There are no runs yet.</source>
        <translation>Δεν υπάρχουν εκτελέσεις ακόμη.</translation>
    </message>
    <message>
        <source>no interval</source>
        <translation>χωρίς διάστημα</translation>
    </message>
    <message>
        <source>95 %: %1</source>
        <translation>95 %: %1</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Κλάσμα Weber</translation>
    </message>
    <message>
        <source>JND at the reference</source>
        <translation>JND στην αναφορά</translation>
    </message>
    <message>
        <source>Point of subjective equality</source>
        <translation>Σημείο υποκειμενικής ισότητας</translation>
    </message>
    <message>
        <source>%1. %2. %3 scored trials, %4 repeated. %5</source>
        <translation>%1. %2. %3 βαθμολογημένες δοκιμές, %4 επαναλήφθηκαν. %5</translation>
    </message>
    <message numerus="yes">
        <source>Replayed from its log, the procedure makes the same %n choice(s).</source>
        <translation>
            <numerusform>Αν επαναληφθεί από το αρχείο της, η διαδικασία κάνει την ίδια %n επιλογή.</numerusform>
            <numerusform>Αν επαναληφθεί από το αρχείο της, η διαδικασία κάνει τις ίδιες %n επιλογές.</numerusform>
        </translation>
    </message>
    <message>
        <source>Replayed from its log, the procedure makes different choices: only %1 of %2 match.</source>
        <translation>Αν επαναληφθεί από το αρχείο της, η διαδικασία επιλέγει διαφορετικά: μόνο %1 από %2 συμπίπτουν.</translation>
    </message>
    <message>
        <source>Proportion correct by difference</source>
        <translation>Ποσοστό σωστών απαντήσεων ανά διαφορά</translation>
    </message>
    <message>
        <source>This task has no psychometric curve</source>
        <translation>Το έργο αυτό δεν έχει ψυχομετρική καμπύλη</translation>
    </message>
    <message>
        <source>Equality threshold (σ)</source>
        <translation>Κατώφλι ισότητας (σ)</translation>
    </message>
    <message>
        <source>Exponent of the power law</source>
        <translation>Εκθέτης του νόμου δύναμης</translation>
    </message>
    <message>
        <source>In the group value: %1.</source>
        <translation>Στην τιμή της ομάδας: %1.</translation>
    </message>
    <message>
        <source>The masking sound was not heard in %1 of %2 trials: the machine had no sound output.</source>
        <translation>Ο ήχος κάλυψης δεν ακούστηκε σε %1 από %2 δοκιμές: ο υπολογιστής δεν είχε έξοδο ήχου.</translation>
    </message>
    <message>
        <source>Internal noise</source>
        <translation>Εσωτερικός θόρυβος</translation>
    </message>
    <message>
        <source>How much the same object feels different from one time to the next (one standard deviation).</source>
        <translation>Πόσο διαφορετικό γίνεται αισθητό το ίδιο αντικείμενο από φορά σε φορά (μία τυπική απόκλιση).</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PilotDialog</name>
    <message>
        <source>Pilot run</source>
        <translation>Πιλοτική δοκιμή</translation>
    </message>
    <message>
        <source>The design is tried exactly as it is now. The run is marked as a pilot and never analysed with the study&apos;s data. Stop whenever you have seen enough.</source>
        <translation>Το σχέδιο δοκιμάζεται ακριβώς όπως είναι τώρα. Η εκτέλεση σημειώνεται ως πιλοτική και ποτέ δεν αναλύεται με τα δεδομένα της μελέτης. Σταματήστε όταν έχετε δει αρκετά.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Συνθήκη</translation>
    </message>
    <message>
        <source>Who tries it (may be left empty)</source>
        <translation>Ποιος το δοκιμάζει (προαιρετικό)</translation>
    </message>
    <message>
        <source>Whoever tries it has read this and agrees</source>
        <translation>Όποιος το δοκιμάζει διάβασε το κείμενο και συμφωνεί</translation>
    </message>
    <message>
        <source>Begin the pilot</source>
        <translation>Έναρξη πιλοτικής δοκιμής</translation>
    </message>
    <message>
        <source>The pilot could not begin.
%1</source>
        <translation>Η πιλοτική δοκιμή δεν μπόρεσε να αρχίσει.
%1</translation>
    </message>
    <message>
        <source>Tick the box first: whoever tries it must agree.</source>
        <translation>Τσεκάρετε πρώτα το πλαίσιο: όποιος τη δοκιμάζει πρέπει να συμφωνεί.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlacesView</name>
    <message>
        <source>Objects to explore</source>
        <translation>Αντικείμενα προς εξερεύνηση</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Δύναμη</translation>
    </message>
    <message>
        <source>Limit: %1 N</source>
        <translation>Όριο: %1 N</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlatformCard</name>
    <message>
        <source>Fingertip platform</source>
        <translation>Πλατφόρμα δακτύλου</translation>
    </message>
    <message>
        <source>Verification of the simulated platform: the published sine and orientations, force steps, and the maximum force on the finger pad, on eight simulated fingers.</source>
        <translation>Επαλήθευση της προσομοιωμένης πλατφόρμας: το δημοσιευμένο ημίτονο και οι προσανατολισμοί, βήματα δύναμης και η μέγιστη δύναμη στο δάκτυλο, σε οκτώ προσομοιωμένα δάκτυλα.</translation>
    </message>
    <message>
        <source>Verify the platform</source>
        <translation>Έλεγχος</translation>
    </message>
    <message>
        <source>Record (PDF) …</source>
        <translation>Πρακτικό (PDF) …</translation>
    </message>
    <message>
        <source>The verification was stopped before it finished.</source>
        <translation>Ο έλεγχος διακόπηκε πριν ολοκληρωθεί.</translation>
    </message>
    <message>
        <source>The verification could not be done: %1</source>
        <translation>Ο έλεγχος δεν ήταν δυνατός: %1</translation>
    </message>
    <message>
        <source>Verification of the simulated fingertip platform</source>
        <translation>Επαλήθευση της προσομοιωμένης πλατφόρμας δακτύλου</translation>
    </message>
    <message>
        <source>A researcher or an administrator can run it here.</source>
        <translation>Ένας ερευνητής ή διαχειριστής μπορεί να τον εκτελέσει εδώ.</translation>
    </message>
    <message>
        <source>Passed.</source>
        <translation>Επιτυχία.</translation>
    </message>
    <message>
        <source>Failed.</source>
        <translation>Αποτυχία.</translation>
    </message>
    <message>
        <source>Serial number: %1</source>
        <translation>Αριθμός σειράς: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlaybackPlots</name>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Ταχύτητα (mm/s)</translation>
    </message>
    <message>
        <source>Off-centre (mm)</source>
        <translation>Απόκλιση (mm)</translation>
    </message>
    <message>
        <source>Alignment (°)</source>
        <translation>Ευθυγράμμιση (°)</translation>
    </message>
    <message>
        <source>Tension of the tube</source>
        <translation>Τάση του σωλήνα</translation>
    </message>
    <message>
        <source>Squeeze of the jaws</source>
        <translation>Σύσφιξη των σιαγόνων</translation>
    </message>
    <message>
        <source>band, from</source>
        <translation>ζώνη, από</translation>
    </message>
    <message>
        <source>band, to</source>
        <translation>ζώνη, έως</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>πάνω από το όριο</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>όριο</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>τάση</translation>
    </message>
    <message>
        <source>squeeze</source>
        <translation>σύσφιξη</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>παύση</translation>
    </message>
    <message>
        <source>Tension (N), dashed: target band</source>
        <translation>Τάση (N), διακεκομμένη: ζώνη στόχου</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Σύσφιξη (N)</translation>
    </message>
    <message>
        <source>Energy supplied by the hand and stored in the object</source>
        <translation>Ενέργεια που δίνει το χέρι και ενέργεια που αποθηκεύεται στο αντικείμενο</translation>
    </message>
    <message>
        <source>more stored than supplied</source>
        <translation>περισσότερη από όση δόθηκε</translation>
    </message>
    <message>
        <source>supplied</source>
        <translation>δόθηκε</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>αποθηκευμένη</translation>
    </message>
    <message>
        <source>Energy (mJ)</source>
        <translation>Ενέργεια (mJ)</translation>
    </message>
    <message>
        <source>finger %1</source>
        <translation>δάκτυλο %1</translation>
    </message>
    <message>
        <source>finger</source>
        <translation>δάκτυλο</translation>
    </message>
    <message>
        <source>Tilt of the force</source>
        <translation>Κλίση της δύναμης</translation>
    </message>
    <message>
        <source>maximum tilt of the platform</source>
        <translation>μέγιστη κλίση της πλατφόρμας</translation>
    </message>
    <message>
        <source>Tilt (°), line: limit of the platform</source>
        <translation>Κλίση (°), γραμμή: όριο της πλατφόρμας</translation>
    </message>
    <message>
        <source>Depth of the fingers</source>
        <translation>Βάθος των δακτύλων</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Βάθος (mm)</translation>
    </message>
    <message>
        <source>Pull on the fold of tissue</source>
        <translation>Έλξη της πτυχής ιστού</translation>
    </message>
    <message>
        <source>pull</source>
        <translation>έλξη</translation>
    </message>
    <message>
        <source>Pull on the fold (N), dashed: target band</source>
        <translation>Έλξη της πτυχής (N), διακεκομμένη: ζώνη στόχου</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Tissue force (N)</source>
        <translation>Δύναμη ιστού (N)</translation>
    </message>
    <message>
        <source>Force felt (N)</source>
        <translation>Αισθητή δύναμη (N)</translation>
    </message>
    <message>
        <source>Zoom in: show less time (+)</source>
        <translation>Μεγέθυνση: μικρότερο διάστημα (+)</translation>
    </message>
    <message>
        <source>Zoom out: show more time (-)</source>
        <translation>Σμίκρυνση: μεγαλύτερο διάστημα (-)</translation>
    </message>
    <message>
        <source>Show the whole session (0)</source>
        <translation>Ολόκληρη η συνεδρία (0)</translation>
    </message>
    <message>
        <source>Time in the recording (s)</source>
        <translation>Χρόνος στην καταγραφή (s)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlaybackScreen</name>
    <message>
        <source>The sessions for comparison could not be loaded.</source>
        <translation>Δεν ήταν δυνατή η φόρτωση συνεδριών για σύγκριση.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>My first attempt, %1</source>
        <translation>Η πρώτη μου προσπάθεια, %1</translation>
    </message>
    <message>
        <source>First attempt of %1, %2</source>
        <translation>Πρώτη προσπάθεια: %1, %2</translation>
    </message>
    <message>
        <source>My best attempt, %1</source>
        <translation>Η καλύτερή μου προσπάθεια, %1</translation>
    </message>
    <message>
        <source>Best attempt of %1, %2</source>
        <translation>Καλύτερη προσπάθεια: %1, %2</translation>
    </message>
    <message>
        <source>No other completed session of this level</source>
        <translation>Καμία άλλη ολοκληρωμένη συνεδρία του επιπέδου</translation>
    </message>
    <message>
        <source>The second session could not be read. This one is shown alone.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση της δεύτερης συνεδρίας. Προβάλλεται μόνο αυτή.</translation>
    </message>
    <message>
        <source>Declared void: %1</source>
        <translation>Ακυρώθηκε: %1</translation>
    </message>
    <message>
        <source>%1, level %2: %3</source>
        <translation>%1, επίπεδο %2: %3</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 · %4</source>
        <translation>%1 · %2 · %3 · %4</translation>
    </message>
    <message>
        <source>Debrief</source>
        <translation>Απολογισμός</translation>
    </message>
    <message>
        <source>Declare void …</source>
        <translation>Ακύρωση συνεδρίας …</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Συμβάντα</translation>
    </message>
    <message>
        <source>Second session alongside</source>
        <translation>Δεύτερη συνεδρία δίπλα</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Καμία</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Αναπαραγωγή</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Αναπαραγωγή ή παύση</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Ένα καρέ εμπρός</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Ένα καρέ πίσω</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Επόμενο συμβάν</translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation>Προηγούμενο συμβάν</translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation>Στην αρχή</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Στο τέλος</translation>
    </message>
    <message>
        <source>This recording is damaged and cannot be played back. Its scores are kept.</source>
        <translation>Αυτή η καταγραφή έχει υποστεί βλάβη και δεν αναπαράγεται. Οι βαθμολογίες της διατηρούνται.</translation>
    </message>
    <message>
        <source>This session could not be opened</source>
        <translation>Δεν ήταν δυνατό το άνοιγμα αυτής της συνεδρίας</translation>
    </message>
    <message>
        <source>Reading the recording …</source>
        <translation>Ανάγνωση της καταγραφής …</translation>
    </message>
    <message>
        <source>The recording was erased</source>
        <translation>Η καταγραφή διαγράφηκε</translation>
    </message>
    <message>
        <source>It was erased at the person&apos;s request. The scores are kept.</source>
        <translation>Διαγράφηκε κατόπιν αιτήματος του ατόμου. Οι βαθμολογίες διατηρούνται.</translation>
    </message>
    <message>
        <source>Open the debrief</source>
        <translation>Άνοιγμα απολογισμού</translation>
    </message>
    <message>
        <source>Nothing was recorded</source>
        <translation>Δεν καταγράφηκε τίποτα</translation>
    </message>
    <message>
        <source>This session ended before its first sample. It is kept and listed.</source>
        <translation>Αυτή η συνεδρία τελείωσε πριν από το πρώτο δείγμα. Διατηρείται και υπάρχει στη λίστα.</translation>
    </message>
    <message>
        <source>The scene at this moment</source>
        <translation>Η σκηνή αυτή τη στιγμή</translation>
    </message>
    <message>
        <source>Trial %1 · force %2 · speed %3</source>
        <translation>Δοκιμή %1 · δύναμη %2 · ταχύτητα %3</translation>
    </message>
    <message>
        <source>The comments could not be read.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση των σχολίων.</translation>
    </message>
    <message>
        <source>The comment was not saved. Its text is still here.</source>
        <translation>Το σχόλιο δεν αποθηκεύτηκε. Το κείμενο υπάρχει ακόμη.</translation>
    </message>
    <message>
        <source>second session</source>
        <translation>δεύτερη συνεδρία</translation>
    </message>
    <message>
        <source>Depth of field</source>
        <translation>Βάθος πεδίου</translation>
    </message>
    <message>
        <source>The picture is sharp at one distance only, as through a real endoscope</source>
        <translation>Η εικόνα είναι εστιασμένη σε μία μόνο απόσταση, όπως σε πραγματικό ενδοσκόπιο</translation>
    </message>
    <message>
        <source>%1 · depth %2 · force %3 · speed %4</source>
        <translation>%1 · βάθος %2 · δύναμη %3 · ταχύτητα %4</translation>
    </message>
    <message>
        <source>squeeze %1</source>
        <translation>σύσφιξη %1</translation>
    </message>
    <message>
        <source>tension %1</source>
        <translation>τάση %1</translation>
    </message>
    <message>
        <source>Trial %1 · %2 · force %3 · speed %4</source>
        <translation>Δοκιμή %1 · %2 · δύναμη %3 · ταχύτητα %4</translation>
    </message>
    <message>
        <source>Show the lumps</source>
        <translation>Εμφάνιση των όζων</translation>
    </message>
    <message>
        <source>Where the lumps were, and how the findings were scored</source>
        <translation>Πού ήταν οι όζοι και πώς βαθμολογήθηκαν τα ευρήματα</translation>
    </message>
    <message>
        <source>Map of the whole trial</source>
        <translation>Χάρτης όλης της δοκιμής</translation>
    </message>
    <message>
        <source>Off: the map up to this moment</source>
        <translation>Όχι: ο χάρτης έως αυτή τη στιγμή</translation>
    </message>
    <message>
        <source>Force map</source>
        <translation>Χάρτης δύναμης</translation>
    </message>
    <message>
        <source>On: how hard the tissue was pressed. Off: where it was searched.</source>
        <translation>Ναι: πόσο δυνατά πιέστηκε ο ιστός. Όχι: πού ερευνήθηκε.</translation>
    </message>
    <message>
        <source>Trial %1 · force %2 · tilt %3° · depth %4 · searched %5 % · findings %6</source>
        <translation>Δοκιμή %1 · δύναμη %2 · κλίση %3° · βάθος %4 · ερευνήθηκε %5 % · ευρήματα %6</translation>
    </message>
    <message>
        <source>Findings and maps could not be read from the recording: %1</source>
        <translation>Τα ευρήματα και οι χάρτες δεν διαβάστηκαν από την καταγραφή: %1</translation>
    </message>
    <message>
        <source>Trial %1 · %7 · force %2 · tilt %3° · depth %4 · searched %5 % · findings %6</source>
        <translation>Δοκιμή %1 · %7 · δύναμη %2 · κλίση %3° · βάθος %4 · ερευνήθηκε %5 % · ευρήματα %6</translation>
    </message>
    <message>
        <source>force stopped</source>
        <translation>διακοπή δύναμης</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>παύση</translation>
    </message>
    <message>
        <source>%1 · %2 · depth %3 · force %4 · speed %5</source>
        <translation>%1 · %2 · βάθος %3 · δύναμη %4 · ταχύτητα %5</translation>
    </message>
    <message>
        <source>Trial %1 · %2 · %3 · force %4 · speed %5</source>
        <translation>Δοκιμή %1 · %2 · %3 · δύναμη %4 · ταχύτητα %5</translation>
    </message>
    <message>
        <source>Comments (C)</source>
        <translation>Σχόλια (C)</translation>
    </message>
    <message>
        <source>A session as it was recorded.

Space plays and pauses. The arrow keys move one frame forward or back, with Shift one second, with Ctrl to the next or previous event; Home and End jump to the beginning and the end. Clicking in a plot jumps to that time. Plus and minus zoom the plots, 0 shows the whole session.

C writes a comment at the moment shown.

Pauses are hatched, and skipped unless you switch that off. Triangles on the time bar are penalties, flags are answers, squares below it are comments.

Choose a second session to see it beside this one: each of its trials starts together with the trial here and is drawn in the same place.</source>
        <translation>Μια συνεδρία όπως καταγράφηκε.

Το Διάστημα αναπαράγει και σταματά. Τα βέλη πηγαίνουν ένα καρέ εμπρός ή πίσω, με Shift ένα δευτερόλεπτο, με Ctrl στο επόμενο ή το προηγούμενο συμβάν· τα Home και End στην αρχή και στο τέλος. Ένα κλικ σε διάγραμμα πηγαίνει σε εκείνη τη χρονική στιγμή. Τα + και − μεγεθύνουν και σμικρύνουν τα διαγράμματα, το 0 δείχνει ολόκληρη τη συνεδρία.

Με το C γράφετε σχόλιο για τη στιγμή που φαίνεται.

Οι παύσεις είναι διαγραμμισμένες και παραλείπονται, εκτός αν το απενεργοποιήσετε. Τα τρίγωνα στη γραμμή χρόνου είναι ποινές, οι σημαίες απαντήσεις, τα τετράγωνα από κάτω σχόλια.

Επιλέξτε δεύτερη συνεδρία για να τη δείτε δίπλα σε αυτήν: κάθε δοκιμή της αρχίζει μαζί με τη δοκιμή εδώ και σχεδιάζεται στην ίδια θέση.</translation>
    </message>
    <message>
        <source>Write a comment at this moment</source>
        <translation>Σχόλιο για αυτή τη στιγμή</translation>
    </message>
    <message>
        <source>Zoom in on the plots</source>
        <translation>Μεγέθυνση των διαγραμμάτων</translation>
    </message>
    <message>
        <source>Zoom out of the plots</source>
        <translation>Σμίκρυνση των διαγραμμάτων</translation>
    </message>
    <message>
        <source>The whole session in the plots</source>
        <translation>Ολόκληρη η συνεδρία στα διαγράμματα</translation>
    </message>
    <message>
        <source>Session %1 was not voided; nothing was changed.</source>
        <translation>Η συνεδρία %1 δεν ακυρώθηκε· τίποτα δεν άλλαξε.</translation>
    </message>
    <message>
        <source>Session %1 is voided. Its recording is kept; it no longer counts.</source>
        <translation>Η συνεδρία %1 ακυρώθηκε. Η καταγραφή της διατηρείται· δεν μετράει πλέον.</translation>
    </message>
    <message>
        <source>The comment is saved. %1 will see it on Home.</source>
        <translation>Το σχόλιο αποθηκεύτηκε. Ο/Η %1 θα το δει στην «Αρχική».</translation>
    </message>
    <message>
        <source>The comment is saved, and the session counts as reviewed. %1 will see it on Home.</source>
        <translation>Το σχόλιο αποθηκεύτηκε και η συνεδρία θεωρείται αξιολογημένη. Ο/Η %1 θα το δει στην «Αρχική».</translation>
    </message>
    <message>
        <source>This session was void and counts again. The debrief says who decided it and why.</source>
        <translation>Αυτή η συνεδρία είχε ακυρωθεί και μετράει ξανά. Ο απολογισμός λέει ποιος το αποφάσισε και γιατί.</translation>
    </message>
    <message>
        <source>%1, attempt %2 at level %3: %4</source>
        <translation>%1, προσπάθεια %2 στο επίπεδο %3: %4</translation>
    </message>
    <message>
        <source>Count it again …</source>
        <translation>Να μετράει ξανά …</translation>
    </message>
    <message>
        <source>Session %1 counts again. Its history still shows that it was void.</source>
        <translation>Η συνεδρία %1 μετράει ξανά. Η ακύρωσή της παραμένει καταγεγραμμένη.</translation>
    </message>
    <message>
        <source>Session %1 is still void; nothing was changed.</source>
        <translation>Η συνεδρία %1 παραμένει ακυρωμένη· δεν άλλαξε τίποτα.</translation>
    </message>
    <message>
        <source>A cross in the scene shows where tissue gave way, or where an object of a study came off the tool.</source>
        <translation>Ένας σταυρός στη σκηνή δείχνει πού υποχώρησε ιστός ή πού ξέφυγε από το εργαλείο αντικείμενο μιας μελέτης.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PreviewPage</name>
    <message>
        <source>Their Weber fraction</source>
        <translation>Το κλάσμα Weber τους</translation>
    </message>
    <message>
        <source>Lapse rate</source>
        <translation>Ποσοστό αβλεψιών</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Άκυρο</translation>
    </message>
    <message>
        <source>expected bias of the Weber fraction</source>
        <translation>αναμενόμενη μεροληψία του κλάσματος Weber</translation>
    </message>
    <message>
        <source>precision: SD of one run, as a factor</source>
        <translation>ακρίβεια: SD μίας εκτέλεσης, ως παράγοντας</translation>
    </message>
    <message>
        <source>95 % intervals that contain the true value</source>
        <translation>διαστήματα 95 % που περιέχουν την αληθινή τιμή</translation>
    </message>
    <message>
        <source>How the estimate converges with more trials</source>
        <translation>Πώς σταθεροποιείται η εκτίμηση με περισσότερες δοκιμές</translation>
    </message>
    <message>
        <source>Trials of a run</source>
        <translation>Δοκιμές μίας εκτέλεσης</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Κλάσμα Weber (%)</translation>
    </message>
    <message numerus="yes">
        <source>median of %n run(s)</source>
        <translation>
            <numerusform>%n εκτέλεση</numerusform>
            <numerusform>διάμεσος %n εκτελέσεων</numerusform>
        </translation>
    </message>
    <message>
        <source>middle 80 %</source>
        <translation>μεσαίο 80 %</translation>
    </message>
    <message>
        <source>true value</source>
        <translation>αληθινή τιμή</translation>
    </message>
    <message>
        <source>Equality threshold (σ)</source>
        <translation>Κατώφλι ισότητας (σ)</translation>
    </message>
    <message>
        <source>Runs per condition</source>
        <translation>Εκτελέσεις ανά συνθήκη</translation>
    </message>
    <message>
        <source>±: one standard error of so few simulated runs; more runs make it smaller.</source>
        <translation>±: ένα τυπικό σφάλμα τόσο λίγων προσομοιωμένων εκτελέσεων· περισσότερες εκτελέσεις το μικραίνουν.</translation>
    </message>
    <message>
        <source>For comparing two conditions, the variation between people is assumed, not simulated. Changes take effect at once.</source>
        <translation>Για τη σύγκριση δύο συνθηκών, η διακύμανση μεταξύ ατόμων είναι παραδοχή και δεν προσομοιώνεται. Οι αλλαγές ισχύουν αμέσως.</translation>
    </message>
    <message>
        <source>Each participant does both conditions</source>
        <translation>Κάθε συμμετέχων κάνει και τις δύο συνθήκες</translation>
    </message>
    <message>
        <source>Significance level, two-sided</source>
        <translation>Επίπεδο σημαντικότητας, δίπλευρο</translation>
    </message>
    <message>
        <source>Desired power</source>
        <translation>Επιθυμητή ισχύς</translation>
    </message>
    <message>
        <source>none up to × 10</source>
        <translation>κανένας έως × 10</translation>
    </message>
    <message>
        <source>How well an apex is found is planned with the published spread of marks, %1 of the radius along each axis.</source>
        <translation>Το πόσο καλά βρίσκεται μια κορυφή προγραμματίζεται με τη δημοσιευμένη διασπορά των σημείων: %1 της ακτίνας ανά άξονα.</translation>
    </message>
    <message>
        <source>How many people are compared.</source>
        <translation>Πόσα άτομα συγκρίνονται.</translation>
    </message>
    <message>
        <source>How often a difference may be found where there is none.</source>
        <translation>Πόσο συχνά επιτρέπεται να βρεθεί διαφορά εκεί που δεν υπάρχει.</translation>
    </message>
    <message>
        <source>spread of one mark along an axis, as published</source>
        <translation>διασπορά ενός σημείου ανά άξονα, όπως δημοσιεύτηκε</translation>
    </message>
    <message>
        <source>standard error of one participant&apos;s bias</source>
        <translation>τυπικό σφάλμα της μετατόπισης ενός ατόμου</translation>
    </message>
    <message numerus="yes">
        <source>standard error of the bias of %n participant(s), if they do not differ</source>
        <translation>
            <numerusform>τυπικό σφάλμα της μετατόπισης %n ατόμου, αν δεν διαφέρουν</numerusform>
            <numerusform>τυπικό σφάλμα της μετατόπισης %n ατόμων, αν δεν διαφέρουν</numerusform>
        </translation>
    </message>
    <message>
        <source>± one standard error</source>
        <translation>± ένα τυπικό σφάλμα</translation>
    </message>
    <message>
        <source>Paired: SD of the difference from person to person</source>
        <translation>Ζευγαρωτά: τυπική απόκλιση της διαφοράς ανά άτομο</translation>
    </message>
    <message>
        <source>Two groups: SD between people</source>
        <translation>Δύο ομάδες: τυπική απόκλιση μεταξύ ατόμων</translation>
    </message>
    <message>
        <source>How much the difference varies between people: 12 % is a factor of 1.12.</source>
        <translation>Πόσο μεταβάλλεται η διαφορά από άτομο σε άτομο: το 12 % είναι συντελεστής 1,12.</translation>
    </message>
    <message>
        <source>How much people vary: 40 % is a factor of 1.4.</source>
        <translation>Πόσο διαφέρουν τα άτομα: το 40 % είναι συντελεστής 1,4.</translation>
    </message>
    <message>
        <source>Share of their answers that is careless.</source>
        <translation>Ποσοστό των απρόσεκτων απαντήσεών τους.</translation>
    </message>
    <message>
        <source>Simulated observers call smaller differences equal; in standard deviations of what they feel.</source>
        <translation>Μικρότερες διαφορές οι προσομοιωμένοι παρατηρητές τις θεωρούν ίσες· σε τυπικές αποκλίσεις όσων αισθάνονται.</translation>
    </message>
    <message>
        <source>More runs take longer and give more precise figures.</source>
        <translation>Περισσότερες εκτελέσεις διαρκούν περισσότερο και δίνουν ακριβέστερους αριθμούς.</translation>
    </message>
    <message>
        <source>Otherwise each person does one of them.</source>
        <translation>Διαφορετικά κάθε άτομο κάνει μία από αυτές.</translation>
    </message>
    <message>
        <source>How often an existing difference should be found.</source>
        <translation>Πόσο συχνά πρέπει να βρίσκεται μια υπαρκτή διαφορά.</translation>
    </message>
    <message>
        <source>The just noticeable difference of these observers, as a share of the reference.</source>
        <translation>Η ελάχιστη αντιληπτή διαφορά αυτών των παρατηρητών, ως ποσοστό της αναφοράς.</translation>
    </message>
    <message>
        <source>Participants (with two groups: in each)</source>
        <translation>Συμμετέχοντες (με δύο ομάδες: ανά ομάδα)</translation>
    </message>
    <message>
        <source>While the study is blinded, its conditions and their expected precision are sealed. Only the study&apos;s author can estimate it.</source>
        <translation>Όσο η μελέτη είναι τυφλή, οι συνθήκες της και η αναμενόμενη ακρίβειά τους είναι σφραγισμένες. Μόνο όποιος δημιούργησε τη μελέτη μπορεί να την εκτιμήσει.</translation>
    </message>
    <message>
        <source>The program calculates how precise the results will be: simulated observers, whose true values are known, run through the study without haptic rendering. They are no participants, and nothing of it is stored as data. To see the study as a participant does, use Pilot run under Check and freeze.</source>
        <translation>Το πρόγραμμα υπολογίζει πόσο ακριβή θα είναι τα αποτελέσματα: προσομοιωμένοι παρατηρητές, με γνωστές πραγματικές τιμές, διατρέχουν τη μελέτη χωρίς απτική απόδοση. Δεν είναι συμμετέχοντες, και τίποτα δεν αποθηκεύεται ως δεδομένα. Για να δείτε τη μελέτη όπως τη βλέπει ένας συμμετέχων, ξεκινήστε πιλοτική δοκιμή στη σελίδα «Έλεγχος και οριστικοποίηση».</translation>
    </message>
    <message>
        <source>Estimate the precision</source>
        <translation>Εκτίμηση της ακρίβειας</translation>
    </message>
    <message>
        <source>Progress of the simulation</source>
        <translation>Πρόοδος της προσομοίωσης</translation>
    </message>
    <message>
        <source>The precision could not be estimated. %1</source>
        <translation>Η ακρίβεια δεν ήταν δυνατό να εκτιμηθεί. %1</translation>
    </message>
    <message>
        <source>trials of one run of this condition</source>
        <translation>δοκιμές μίας εκτέλεσης αυτής της συνθήκης</translation>
    </message>
    <message>
        <source>minutes of one run, breaks included</source>
        <translation>λεπτά μίας εκτέλεσης, με τα διαλείμματα</translation>
    </message>
    <message>
        <source>smallest ratio of two conditions&apos; Weber fractions that is found with %1 power and %2 participants who do both conditions</source>
        <translation>μικρότερος λόγος των κλασμάτων Weber δύο συνθηκών που βρίσκεται με ισχύ %1 και %2 συμμετέχοντες που κάνουν και τις δύο συνθήκες</translation>
    </message>
    <message>
        <source>smallest ratio of two conditions&apos; Weber fractions that is found with %1 power and two groups of %2 participants</source>
        <translation>μικρότερος λόγος των κλασμάτων Weber δύο συνθηκών που βρίσκεται με ισχύ %1 και δύο ομάδες των %2 συμμετεχόντων</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ProcedureForm</name>
    <message>
        <source>Procedure</source>
        <translation>Διαδικασία</translation>
    </message>
    <message>
        <source>Change of the procedure</source>
        <translation>Αλλαγή της διαδικασίας</translation>
    </message>
    <message>
        <source>Logarithmic steps of an imported design.</source>
        <translation>Λογαριθμικά βήματα εισηγμένου σχεδίου.</translation>
    </message>
    <message>
        <source>Factors of the difference, usually 1.26.</source>
        <translation>Συντελεστές της διαφοράς, συνήθως 1,26.</translation>
    </message>
    <message>
        <source>In per cent of the reference.</source>
        <translation>Επί τοις εκατό της αναφοράς.</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Δοκιμές</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Κατώφλι</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Διασπορά</translation>
    </message>
    <message>
        <source>%1 (%)</source>
        <translation>%1 (%)</translation>
    </message>
    <message>
        <source>%1: from</source>
        <translation>%1: από</translation>
    </message>
    <message>
        <source>%1: to</source>
        <translation>%1: έως</translation>
    </message>
    <message>
        <source>%1: steps</source>
        <translation>%1: βήματα</translation>
    </message>
    <message>
        <source>More steps are finer, and take longer to compute.</source>
        <translation>Περισσότερα βήματα είναι λεπτότερα και απαιτούν περισσότερο υπολογισμό.</translation>
    </message>
    <message>
        <source>Choice of the procedure</source>
        <translation>Επιλογή της διαδικασίας</translation>
    </message>
    <message>
        <source>How many times each participant searches for the apex.</source>
        <translation>Πόσες φορές αναζητά κάθε άτομο την κορυφή.</translation>
    </message>
    <message>
        <source>Possible shares of wrong answers to differences that are felt.</source>
        <translation>Πιθανά ποσοστά λανθασμένων απαντήσεων σε διαφορές που γίνονται αισθητές.</translation>
    </message>
    <message>
        <source>Share of answers that are right by guessing: 50 % with two alternatives.</source>
        <translation>Ποσοστό σωστών απαντήσεων από τύχη: 50 % με δύο εναλλακτικές.</translation>
    </message>
    <message>
        <source>The largest value that is considered possible.</source>
        <translation>Η μεγαλύτερη τιμή που θεωρείται πιθανή.</translation>
    </message>
    <message>
        <source>The largest value. The imported design spaces these values irregularly; after a change they are spaced regularly.</source>
        <translation>Η μεγαλύτερη τιμή. Το σχέδιο που εισήχθη κατανέμει τις τιμές ακανόνιστα· μετά από μια αλλαγή κατανέμονται ομοιόμορφα.</translation>
    </message>
    <message>
        <source>The threshold is assumed to lie between these two values.</source>
        <translation>Θεωρείται ότι το κατώφλι βρίσκεται μεταξύ αυτών των δύο τιμών.</translation>
    </message>
    <message>
        <source>The spread of the answers is assumed to lie between these two values.</source>
        <translation>Θεωρείται ότι η διασπορά των απαντήσεων βρίσκεται μεταξύ αυτών των δύο τιμών.</translation>
    </message>
    <message>
        <source>Slopes that are considered possible: how steeply the share of right answers grows with the difference. Usually 1.5 to 7.</source>
        <translation>Κλίσεις που θεωρούνται πιθανές: πόσο απότομα αυξάνεται το ποσοστό σωστών απαντήσεων με τη διαφορά. Συνήθως 1,5 έως 7.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ProgressScreen</name>
    <message>
        <source>Progress</source>
        <translation>Πρόοδος</translation>
    </message>
    <message>
        <source>Names, with commas between them</source>
        <translation>Ονόματα, με κόμμα ανάμεσά τους</translation>
    </message>
    <message>
        <source>Names: Ada, Nikos, …</source>
        <translation>Ονόματα: Άντα, Νίκος, …</translation>
    </message>
    <message>
        <source>Which people</source>
        <translation>Ποια άτομα</translation>
    </message>
    <message>
        <source>Everybody</source>
        <translation>Όλα τα άτομα</translation>
    </message>
    <message>
        <source>With sessions to review</source>
        <translation>Με συνεδρίες προς αξιολόγηση</translation>
    </message>
    <message numerus="yes">
        <source>No session in the last %n day(s)</source>
        <translation>
            <numerusform>Καμία συνεδρία εδώ και %n ημέρα</numerusform>
            <numerusform>Καμία συνεδρία εδώ και %n ημέρες</numerusform>
        </translation>
    </message>
    <message>
        <source>Not every level passed</source>
        <translation>Δεν έχουν περάσει όλα τα επίπεδα</translation>
    </message>
    <message>
        <source>Clear the filters</source>
        <translation>Καθαρισμός φίλτρων</translation>
    </message>
    <message>
        <source>Open the sessions</source>
        <translation>Άνοιγμα συνεδριών</translation>
    </message>
    <message>
        <source>Results of this person</source>
        <translation>Αποτελέσματα αυτού του ατόμου</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Φιλτράρισμα κατά όνομα</translation>
    </message>
    <message>
        <source>Reading how far everybody is …</source>
        <translation>Διαβάζεται πόσο έχει προχωρήσει ο καθένας …</translation>
    </message>
    <message>
        <source>The progress of the group could not be read.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση της προόδου της ομάδας.</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n άτομο</numerusform>
            <numerusform>%n άτομα</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 people</source>
        <translation>%1 από %2 άτομα</translation>
    </message>
    <message>
        <source>There are no trainees yet</source>
        <translation>Δεν υπάρχουν ακόμη εκπαιδευόμενοι</translation>
    </message>
    <message>
        <source>As soon as an administrator has added trainees under People, they are listed here, even before they have trained.</source>
        <translation>Μόλις ένας διαχειριστής προσθέσει εκπαιδευόμενους στα «Άτομα», εμφανίζονται εδώ, ακόμη και πριν εκπαιδευτούν.</translation>
    </message>
    <message>
        <source>Nobody matches these filters</source>
        <translation>Κανείς δεν ταιριάζει με αυτά τα φίλτρα</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s) in all.</source>
        <translation>
            <numerusform>Συνολικά %n άτομο.</numerusform>
            <numerusform>Συνολικά %n άτομα.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 has no sessions yet.</source>
        <translation>Για το άτομο %1 δεν υπάρχουν ακόμη συνεδρίες.</translation>
    </message>
    <message>
        <source>How far each person of the group is.

A row is a person. Under each exercise you see the lowest level that the person has not passed, or &quot;All passed&quot;; a cross marks a level that they have tried. &quot;Last session&quot; says when they trained last, and &quot;To review&quot; how many of their sessions await your review. The line below the table says more about the chosen cell: the standing at every level of an exercise, or, at the name, the step that the program offers next. Trainees whose accounts are disabled are left out.

The program keeps no lists of groups: type several names with commas between them to see only these people. The list beside it shows only those who have not trained for some time, or who have not passed everything.

Choose a cell with the arrow keys and press Enter to see the sessions of that person at that exercise.</source>
        <translation>Πόσο έχει προχωρήσει κάθε άτομο της ομάδας.

Κάθε γραμμή είναι ένα άτομο. Κάτω από κάθε άσκηση βρίσκεται το χαμηλότερο επίπεδο που το άτομο δεν έχει περάσει ή «Όλα επιτυχή»· ένας σταυρός δείχνει επίπεδο που έχει ήδη δοκιμάσει. Η «Τελευταία συνεδρία» λέει πότε εκπαιδεύτηκε τελευταία φορά και το «Προς αξιολόγηση» πόσες συνεδρίες του περιμένουν τη δική σας αξιολόγηση. Η γραμμή κάτω από τον πίνακα λέει περισσότερα για το επιλεγμένο κελί: πού βρίσκεται το άτομο σε κάθε επίπεδο μιας άσκησης ή, στο όνομα, τι του προτείνει στη συνέχεια το πρόγραμμα. Οι εκπαιδευόμενοι με απενεργοποιημένο λογαριασμό δεν εμφανίζονται.

Το πρόγραμμα δεν τηρεί λίστες ομάδων: γράψτε μερικά ονόματα με κόμμα ανάμεσά τους για να δείτε μόνο αυτά τα άτομα. Η διπλανή λίστα αφήνει μόνο όσους δεν έχουν εκπαιδευτεί για κάποιο διάστημα ή δεν τα έχουν περάσει όλα.

Επιλέξτε ένα κελί με τα βέλη και πατήστε Enter για να δείτε τις συνεδρίες αυτού του ατόμου σε αυτή την άσκηση.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ProgressTable</name>
    <message>
        <source>Progress of the group</source>
        <translation>Πρόοδος της ομάδας</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Άτομο</translation>
    </message>
    <message>
        <source>Last session</source>
        <translation>Τελευταία συνεδρία</translation>
    </message>
    <message>
        <source>To review</source>
        <translation>Προς αξιολόγηση</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Καμία ακόμη</translation>
    </message>
    <message>
        <source>All passed</source>
        <translation>Όλα επιτυχή</translation>
    </message>
    <message>
        <source>Not begun</source>
        <translation>Δεν ξεκίνησε</translation>
    </message>
    <message numerus="yes">
        <source>Level %1, %n attempt(s)</source>
        <translation>
            <numerusform>Επίπεδο %1, %n προσπάθεια</numerusform>
            <numerusform>Επίπεδο %1, %n προσπάθειες</numerusform>
        </translation>
    </message>
    <message>
        <source>Level %1, not tried</source>
        <translation>Επίπεδο %1, χωρίς προσπάθεια</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1, επίπεδο %2</translation>
    </message>
    <message>
        <source>level %1: %2</source>
        <translation>επίπεδο %1: %2</translation>
    </message>
    <message>
        <source>%1, %2 – %3</source>
        <translation>%1, %2 – %3</translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation>Επίπεδο %1</translation>
    </message>
    <message>
        <source>every level is passed</source>
        <translation>έχουν περαστεί όλα τα επίπεδα</translation>
    </message>
    <message>
        <source>%1 – next step: %2</source>
        <translation>%1 – επόμενο βήμα: %2</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QualityBox</name>
    <message>
        <source>Results stay sealed until the study is unblinded: answers, times and even the number of trials could reveal which condition is which. This page shows how well the trials went, for each participant, across all conditions.</source>
        <translation>Τα αποτελέσματα μένουν σφραγισμένα έως την άρση της τυφλότητας: απαντήσεις, χρόνοι, ακόμη και ο αριθμός των δοκιμών θα μπορούσαν να δείξουν ποια συνθήκη είναι ποια. Εδώ φαίνεται πόσο καλά πήγαν οι δοκιμές, ανά συμμετέχοντα, για όλες τις συνθήκες μαζί.</translation>
    </message>
    <message>
        <source>The number of trials is shown only for participants who have completed every condition.</source>
        <translation>Ο αριθμός των δοκιμών φαίνεται μόνο για όσους ολοκλήρωσαν όλες τις συνθήκες.</translation>
    </message>
    <message>
        <source>Quality of the trials</source>
        <translation>Ποιότητα των δοκιμών</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Κωδικός</translation>
    </message>
    <message>
        <source>Conditions done</source>
        <translation>Ολοκληρωμένες συνθήκες</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Καθυστερημένοι κύκλοι</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Δύναμη</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Βαθμολογημένες</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Επαναλήψεις</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>σφραγισμένο</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 από %2</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>αισθητή</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>μόνο προβολή</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnaireForm</name>
    <message>
        <source>%1 (optional)</source>
        <translation>%1 (προαιρετικό)</translation>
    </message>
    <message>
        <source>Please answer this question.</source>
        <translation>Παρακαλούμε απαντήστε σε αυτή την ερώτηση.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 από %2</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>Από %1 έως %2</translation>
    </message>
    <message>
        <source>Not answered yet: move the slider, or press Space to leave it in the middle.</source>
        <translation>Δεν έχει απαντηθεί ακόμη: μετακινήστε το ρυθμιστικό ή πατήστε το Διάστημα για να μείνει στη μέση.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Βήμα %1 από %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnaireScreen</name>
    <message>
        <source>Questionnaire</source>
        <translation>Ερωτηματολόγιο</translation>
    </message>
    <message>
        <source>Reading the questions …</source>
        <translation>Ανάγνωση των ερωτήσεων …</translation>
    </message>
    <message>
        <source>The questionnaire could not be read</source>
        <translation>Το ερωτηματολόγιο δεν διαβάστηκε</translation>
    </message>
    <message>
        <source>Already answered</source>
        <translation>Έχει ήδη απαντηθεί</translation>
    </message>
    <message>
        <source>Each participant answers a questionnaire once.</source>
        <translation>Κάθε συμμετέχων απαντά σε ένα ερωτηματολόγιο μία φορά.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Πίσω</translation>
    </message>
    <message>
        <source>This questionnaire does not exist</source>
        <translation>Αυτό το ερωτηματολόγιο δεν υπάρχει</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>Συμμετέχων %1</translation>
    </message>
    <message>
        <source>Submit</source>
        <translation>Υποβολή</translation>
    </message>
    <message>
        <source>Thank you. The answers are stored.</source>
        <translation>Ευχαριστούμε. Οι απαντήσεις αποθηκεύτηκαν.</translation>
    </message>
    <message>
        <source>Leave without submitting?</source>
        <translation>Έξοδος χωρίς υποβολή;</translation>
    </message>
    <message>
        <source>The answers on this page are not stored yet.</source>
        <translation>Οι απαντήσεις της σελίδας δεν έχουν αποθηκευτεί ακόμη.</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Παραμονή</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Έξοδος</translation>
    </message>
    <message>
        <source>Each participant answers these questions once, or once about each condition.

Press Tab to move from question to question, the arrow keys to move along a scale, Space to choose. Required questions are marked if they are left unanswered. The answers are stored under the participant&apos;s code as soon as they are submitted.</source>
        <translation>Κάθε συμμετέχων απαντά σε αυτές τις ερωτήσεις μία φορά, ή μία φορά για κάθε συνθήκη.

Με το Tab πηγαίνετε από ερώτηση σε ερώτηση, με τα βέλη κινείστε στην κλίμακα, με το Διάστημα επιλέγετε. Οι υποχρεωτικές ερωτήσεις σημειώνονται όταν μένουν αναπάντητες. Οι απαντήσεις αποθηκεύονται με τον κωδικό του συμμετέχοντα μόλις υποβληθούν.</translation>
    </message>
    <message>
        <source>Each participant answers it once about each condition.</source>
        <translation>Κάθε συμμετέχων απαντά σε αυτό μία φορά για κάθε συνθήκη.</translation>
    </message>
    <message>
        <source>The answers were not stored. They are still on this page: press Submit again, and call the experimenter if that does not help.
%1</source>
        <translation>Οι απαντήσεις δεν αποθηκεύτηκαν. Βρίσκονται ακόμη σε αυτή τη σελίδα: πατήστε ξανά «Υποβολή» και καλέστε τον πειραματιστή αν αυτό δεν βοηθήσει.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnaireSummary</name>
    <message>
        <source>This study has no questionnaires.</source>
        <translation>Η μελέτη δεν έχει ερωτηματολόγια.</translation>
    </message>
    <message>
        <source>Nobody has answered it yet.</source>
        <translation>Κανείς δεν το έχει απαντήσει ακόμη.</translation>
    </message>
    <message numerus="yes">
        <source>Answered by %n participant(s)</source>
        <translation>
            <numerusform>Απαντήθηκε από %n συμμετέχοντα</numerusform>
            <numerusform>Απαντήθηκε από %n συμμετέχοντες</numerusform>
        </translation>
    </message>
    <message>
        <source>No answers</source>
        <translation>Καμία απάντηση</translation>
    </message>
    <message>
        <source>Median %1, interquartile range %2 to %3</source>
        <translation>Διάμεσος %1, ενδοτεταρτημοριακό εύρος %2 έως %3</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«%1»</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Απαντήσεις</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>απαντήσεις</translation>
    </message>
    <message numerus="yes">
        <source>%1: median %2, from %3 to %4, of %n participant(s)</source>
        <translation>
            <numerusform>%1: διάμεσος %2, από %3 έως %4, %n συμμετέχων</numerusform>
            <numerusform>%1: διάμεσος %2, από %3 έως %4, %n συμμετέχοντες</numerusform>
        </translation>
    </message>
    <message>
        <source>Usability score (0 to 100)</source>
        <translation>Βαθμολογία ευχρηστίας (0 έως 100)</translation>
    </message>
    <message>
        <source>Workload (0 to 100)</source>
        <translation>Φόρτος εργασίας (0 έως 100)</translation>
    </message>
    <message>
        <source>Laterality quotient (−100 left, 100 right)</source>
        <translation>Πηλίκο πλευρίωσης (−100 αριστερά, 100 δεξιά)</translation>
    </message>
    <message>
        <source>Answers about single conditions are shown once the study is unblinded.</source>
        <translation>Οι απαντήσεις για μεμονωμένες συνθήκες εμφανίζονται μόλις αρθεί η τυφλότητα της μελέτης.</translation>
    </message>
    <message>
        <source>About the condition %1</source>
        <translation>Για τη συνθήκη %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnairesPage</name>
    <message>
        <source>Scale with labelled ends</source>
        <translation>Κλίμακα με λέξεις στα άκρα</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Αριθμός</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Επιλογή</translation>
    </message>
    <message>
        <source>Free text</source>
        <translation>Ελεύθερο κείμενο</translation>
    </message>
    <message>
        <source>Add a questionnaire</source>
        <translation>Νέο ερωτηματολόγιο</translation>
    </message>
    <message>
        <source>Title of the questionnaire</source>
        <translation>Τίτλος ερωτηματολογίου</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Αναγνωριστικό</translation>
    </message>
    <message>
        <source>Id of a questionnaire</source>
        <translation>Αναγνωριστικό ερωτηματολογίου</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>Απαντάται</translation>
    </message>
    <message>
        <source>before the runs</source>
        <translation>πριν από τις εκτελέσεις</translation>
    </message>
    <message>
        <source>after the runs</source>
        <translation>μετά τις εκτελέσεις</translation>
    </message>
    <message>
        <source>When it is answered</source>
        <translation>Πότε απαντάται</translation>
    </message>
    <message>
        <source>Add a question</source>
        <translation>Νέα ερώτηση</translation>
    </message>
    <message>
        <source>Remove the questionnaire</source>
        <translation>Αφαίρεση ερωτηματολογίου</translation>
    </message>
    <message>
        <source>Change of a question</source>
        <translation>Αλλαγή ερώτησης</translation>
    </message>
    <message>
        <source>Question %1</source>
        <translation>Ερώτηση %1</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Απάντηση</translation>
    </message>
    <message>
        <source>Summarised under</source>
        <translation>Συνοψίζεται ως</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Βαθμίδες</translation>
    </message>
    <message>
        <source>Label at low end</source>
        <translation>Ετικέτα κάτω άκρου</translation>
    </message>
    <message>
        <source>Label at high end</source>
        <translation>Ετικέτα άνω άκρου</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Ελάχιστο</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Μέγιστο</translation>
    </message>
    <message>
        <source>Choices, one per line</source>
        <translation>Επιλογές, μία ανά γραμμή</translation>
    </message>
    <message>
        <source>Must be answered</source>
        <translation>Υποχρεωτική</translation>
    </message>
    <message>
        <source>Remove question %1</source>
        <translation>Αφαίρεση ερώτησης %1</translation>
    </message>
    <message>
        <source>Add a published questionnaire …</source>
        <translation>Προσθήκη δημοσιευμένου ερωτηματολογίου …</translation>
    </message>
    <message>
        <source>Published questionnaires with their scores, and what is written down when a participant is enrolled</source>
        <translation>Δημοσιευμένα ερωτηματολόγια με τη βαθμολόγησή τους, και ό,τι σημειώνεται κατά την εγγραφή ενός συμμετέχοντα</translation>
    </message>
    <message>
        <source>The published questionnaires could not be read.</source>
        <translation>Τα δημοσιευμένα ερωτηματολόγια δεν ήταν δυνατό να διαβαστούν.</translation>
    </message>
    <message>
        <source>Add a published questionnaire</source>
        <translation>Προσθήκη δημοσιευμένου ερωτηματολογίου</translation>
    </message>
    <message>
        <source>when a participant is enrolled</source>
        <translation>κατά την εγγραφή ενός συμμετέχοντα</translation>
    </message>
    <message>
        <source>No questionnaires. Each participant answers a questionnaire once, before or after the runs, or after each condition. The answers are stored with the data.</source>
        <translation>Δεν υπάρχουν ερωτηματολόγια. Κάθε συμμετέχων απαντά σε ένα ερωτηματολόγιο μία φορά, πριν ή μετά τις εκτελέσεις, ή μετά από κάθε συνθήκη. Οι απαντήσεις φυλάσσονται μαζί με τα δεδομένα.</translation>
    </message>
    <message>
        <source>after each condition, about that condition</source>
        <translation>μετά από κάθε συνθήκη, για τη συνθήκη αυτή</translation>
    </message>
    <message>
        <source>The questionnaire “%1” was removed.</source>
        <translation>Το ερωτηματολόγιο «%1» αφαιρέθηκε.</translation>
    </message>
    <message>
        <source>Question %1 was removed.</source>
        <translation>Η ερώτηση %1 αφαιρέθηκε.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RankingBox</name>
    <message>
        <source>reference</source>
        <translation>αναφορά</translation>
    </message>
    <message>
        <source>D more</source>
        <translation>κατά D</translation>
    </message>
    <message>
        <source>2D more</source>
        <translation>κατά 2D</translation>
    </message>
    <message>
        <source>p not known</source>
        <translation>p άγνωστο</translation>
    </message>
    <message>
        <source>p &lt; %1</source>
        <translation>p &lt; %1</translation>
    </message>
    <message>
        <source>p = %1</source>
        <translation>p = %1</translation>
    </message>
    <message>
        <source>Rankings</source>
        <translation>Κατατάξεις</translation>
    </message>
    <message>
        <source>There are no scored rankings yet. Agreement and worths appear here after the first one.</source>
        <translation>Δεν υπάρχουν ακόμη βαθμολογημένες κατατάξεις. Η συμφωνία και οι αξίες θα εμφανιστούν εδώ μετά την πρώτη.</translation>
    </message>
    <message numerus="yes">
        <source>%n ranking(s) of three objects; each is one judgement.</source>
        <translation>
            <numerusform>%n κατάταξη τριών αντικειμένων· καθεμία είναι μία κρίση.</numerusform>
            <numerusform>%n κατατάξεις τριών αντικειμένων· καθεμία είναι μία κρίση.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s); each one&apos;s mean ranks are one judgement.</source>
        <translation>
            <numerusform>%n συμμετέχων· οι μέσες θέσεις του είναι μία κρίση.</numerusform>
            <numerusform>%n συμμετέχοντες· οι μέσες θέσεις του καθενός είναι μία κρίση.</numerusform>
        </translation>
    </message>
    <message>
        <source>no interval</source>
        <translation>χωρίς διάστημα</translation>
    </message>
    <message>
        <source>95 %: %1</source>
        <translation>95 %: %1</translation>
    </message>
    <message>
        <source>Completely correct orders</source>
        <translation>Πλήρως σωστές σειρές</translation>
    </message>
    <message>
        <source>%1 of %2; guessing gives 16.7 %.</source>
        <translation>%1 από %2· οι τυχαίες απαντήσεις δίνουν 16,7 %.</translation>
    </message>
    <message>
        <source>Kendall&apos;s τ</source>
        <translation>τ του Kendall</translation>
    </message>
    <message>
        <source>Similarity to the true order: 1 = identical, 0 = unrelated, −1 = reversed.</source>
        <translation>Ομοιότητα με την πραγματική σειρά: 1 = ίδια, 0 = καμία σχέση, −1 = αντίστροφη.</translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation>W του Kendall</translation>
    </message>
    <message>
        <source>How closely the rankings agree: 0 = not at all, 1 = completely.</source>
        <translation>Πόσο συμφωνούν οι κατατάξεις μεταξύ τους: 0 = καθόλου, 1 = πλήρως.</translation>
    </message>
    <message>
        <source>How closely the participants agree: 0 = not at all, 1 = completely.</source>
        <translation>Πόσο συμφωνούν οι συμμετέχοντες μεταξύ τους: 0 = καθόλου, 1 = πλήρως.</translation>
    </message>
    <message>
        <source>Page&apos;s L</source>
        <translation>L του Page</translation>
    </message>
    <message>
        <source>Trend towards the true order; guessing gives %1 on average.</source>
        <translation>Τάση προς την πραγματική σειρά· με τυχαίες απαντήσεις η μέση τιμή είναι %1.</translation>
    </message>
    <message>
        <source>Worth of each object</source>
        <translation>Αξία κάθε αντικειμένου</translation>
    </message>
    <message>
        <source>How much more often an object was ranked above the others, estimated by three models. The farther apart two values are, the easier the objects are to tell apart. All differences D of the run are pooled, and rankings are treated as independent of each other.</source>
        <translation>Πόσο συχνότερα ένα αντικείμενο κατατάχθηκε πάνω από τα άλλα, κατά την εκτίμηση τριών μοντέλων. Όσο περισσότερο απέχουν οι τιμές, τόσο ευκολότερα διακρίνονται τα αντικείμενα. Όλες οι διαφορές D της εκτέλεσης λαμβάνονται μαζί και οι κατατάξεις θεωρούνται ανεξάρτητες μεταξύ τους.</translation>
    </message>
    <message>
        <source>The worths cannot be estimated: an object was always, or never, ranked above the others. This happens when the difference is very clear.</source>
        <translation>Οι αξίες δεν μπορούν να εκτιμηθούν: ένα αντικείμενο ήταν πάντα, ή ποτέ, πάνω από τα άλλα. Αυτό συμβαίνει όταν η διαφορά είναι πολύ σαφής.</translation>
    </message>
    <message>
        <source>Bradley-Terry</source>
        <translation>Bradley-Terry</translation>
    </message>
    <message>
        <source>ln worth</source>
        <translation>ln αξίας</translation>
    </message>
    <message>
        <source>Plackett-Luce</source>
        <translation>Plackett-Luce</translation>
    </message>
    <message>
        <source>Thurstone</source>
        <translation>Thurstone</translation>
    </message>
    <message>
        <source>Scale (SD of a difference)</source>
        <translation>Κλίμακα (τ.α. διαφοράς)</translation>
    </message>
    <message>
        <source>Not estimable</source>
        <translation>Δεν εκτιμάται</translation>
    </message>
    <message>
        <source>estimate with its 95 % interval</source>
        <translation>εκτίμηση με διάστημα 95 %</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Μοντέλο</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Αντικείμενο</translation>
    </message>
    <message>
        <source>Worth</source>
        <translation>Αξία</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>Διάστημα 95 %</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Μερίδιο</translation>
    </message>
    <message>
        <source>not estimable</source>
        <translation>δεν εκτιμάται</translation>
    </message>
    <message numerus="yes">
        <source>%n ranking(s) contained ties.</source>
        <translation>
            <numerusform>Σε %n κατάταξη υπήρξε ισοβαθμία.</numerusform>
            <numerusform>Σε %n κατατάξεις υπήρξαν ισοβαθμίες.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2; guessing gives 16.7 % or less.</source>
        <translation>%1 από %2· οι τυχαίες απαντήσεις δίνουν 16,7 % ή λιγότερο.</translation>
    </message>
    <message>
        <source>Bradley-Terry, ties by Davidson</source>
        <translation>Bradley-Terry, ισοβαθμίες κατά Davidson</translation>
    </message>
    <message>
        <source>Each answer decided what came next, so one person&apos;s trials are not independent: they have no interval and no p.</source>
        <translation>Κάθε απάντηση όριζε τι ακολουθούσε, άρα οι δοκιμές ενός ατόμου δεν είναι ανεξάρτητες: δεν έχουν διάστημα ούτε p.</translation>
    </message>
    <message>
        <source>no p</source>
        <translation>χωρίς p</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RatingRow</name>
    <message>
        <source>keys 1 to 5</source>
        <translation>πλήκτρα 1 έως 5</translation>
    </message>
    <message>
        <source>%1: %2, %3 of 5</source>
        <translation>%1: %2, %3 από 5</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ReadyCard</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>To pass:
•  %1</source>
        <translation>Για επιτυχία:
•  %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Resume (Enter)</source>
        <translation>Συνέχεια (Enter)</translation>
    </message>
    <message>
        <source>Go (Enter)</source>
        <translation>Έναρξη (Enter)</translation>
    </message>
    <message>
        <source>Practise for a minute</source>
        <translation>Ένα λεπτό εξάσκησης</translation>
    </message>
    <message>
        <source>Try the controls here for a minute. It is recorded as a familiarisation and does not count.</source>
        <translation>Δοκιμάστε εδώ τον χειρισμό για ένα λεπτό. Καταγράφεται ως εξοικείωση και δεν μετράει.</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Περισσότερα</translation>
    </message>
    <message>
        <source>Help for this screen</source>
        <translation>Βοήθεια για αυτή την οθόνη</translation>
    </message>
    <message>
        <source>In the scene:
•  %1</source>
        <translation>Στη σκηνή:
•  %1</translation>
    </message>
    <message>
        <source>Practise for another minute</source>
        <translation>Ακόμη ένα λεπτό εξάσκησης</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Συνέχεια</translation>
    </message>
    <message>
        <source>Watch first</source>
        <translation>Δείτε πρώτα</translation>
    </message>
    <message>
        <source>Watch a scripted expert at this level. Nothing is counted.</source>
        <translation>Παρακολουθήστε σε αυτό το επίπεδο έναν προγραμματισμένο ειδικό. Τίποτα δεν βαθμολογείται.</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Όχι τώρα</translation>
    </message>
    <message>
        <source>Arrow keys: read on</source>
        <translation>Βέλη: συνέχεια ανάγνωσης</translation>
    </message>
    <message>
        <source>Space: read on</source>
        <translation>Διάστημα: συνέχεια ανάγνωσης</translation>
    </message>
    <message>
        <source>Back to the scene (Enter)</source>
        <translation>Πίσω στη σκηνή (Enter)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RecoveryCodeDialog</name>
    <message>
        <source>Make a recovery code</source>
        <translation>Δημιουργία κωδικού ανάκτησης</translation>
    </message>
    <message>
        <source>With a recovery code you can set a new password yourself if you forget yours. It is shown once, to be written down.</source>
        <translation>Με έναν κωδικό ανάκτησης ορίζετε μόνοι σας νέο κωδικό πρόσβασης αν ξεχάσετε τον δικό σας. Εμφανίζεται μία φορά, για να τον σημειώσετε.</translation>
    </message>
    <message>
        <source>The recovery code that you have now will no longer be accepted.</source>
        <translation>Ο κωδικός ανάκτησης που έχετε τώρα δεν θα γίνεται πλέον δεκτός.</translation>
    </message>
    <message>
        <source>Your own password</source>
        <translation>Ο δικός σας κωδικός πρόσβασης</translation>
    </message>
    <message>
        <source>Make the code</source>
        <translation>Δημιουργία</translation>
    </message>
    <message>
        <source>No recovery code was made.
%1</source>
        <translation>Δεν δημιουργήθηκε κωδικός ανάκτησης.
%1</translation>
    </message>
    <message>
        <source>The recovery code is not shown again. Write it down and tick the box first. If you close this window again, it is gone; you can then make a new one.</source>
        <translation>Ο κωδικός ανάκτησης δεν εμφανίζεται ξανά. Πρώτα σημειώστε τον και επιλέξτε το πλαίσιο. Αν κλείσετε ξανά αυτό το παράθυρο, χάνεται· τότε μπορείτε να δημιουργήσετε νέο.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RecoveryCodePanel</name>
    <message>
        <source>Your recovery code</source>
        <translation>Ο κωδικός ανάκτησής σας</translation>
    </message>
    <message>
        <source>Recovery code: %1</source>
        <translation>Κωδικός ανάκτησης: %1</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Αντιγραφή</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Αντιγράφηκε</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Εκτύπωση</translation>
    </message>
    <message>
        <source>I have written the code down</source>
        <translation>Έχω σημειώσει τον κωδικό</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Συνέχεια</translation>
    </message>
    <message>
        <source>Chiron: recovery code of %1

%2

Keep it as safe as your keys.</source>
        <translation>Chiron: κωδικός ανάκτησης για %1

%2

Φυλάξτε τον όπως τα κλειδιά σας.</translation>
    </message>
    <message>
        <source>With this code you can set a new password if you forget yours. It is shown only now: the program keeps no readable copy. Without it, only another administrator can help you. Keep it as safe as your keys.</source>
        <translation>Με αυτόν ορίζετε νέο κωδικό πρόσβασης αν ξεχάσετε τον δικό σας. Εμφανίζεται μόνο τώρα: το πρόγραμμα δεν κρατά αναγνώσιμο αντίγραφο. Χωρίς αυτόν μπορεί να σας βοηθήσει μόνο άλλος διαχειριστής. Φυλάξτε τον όπως τα κλειδιά σας.</translation>
    </message>
    <message>
        <source>Backups made before now still have the earlier code.</source>
        <translation>Τα αντίγραφα ασφαλείας που έγιναν ως τώρα έχουν ακόμη τον προηγούμενο κωδικό.</translation>
    </message>
    <message>
        <source>Backups made before now have no recovery code of yours.</source>
        <translation>Τα αντίγραφα ασφαλείας που έγιναν ως τώρα δεν έχουν δικό σας κωδικό ανάκτησης.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RecoveryPage</name>
    <message>
        <source>Forgot your password?</source>
        <translation>Ξεχάσατε τον κωδικό;</translation>
    </message>
    <message>
        <source>Ask an administrator of this site. Under People, they can give you a new password with &quot;Reset password&quot;. Your sessions and scores are kept.</source>
        <translation>Απευθυνθείτε σε διαχειριστή του κέντρου: στα «Άτομα», με την «Επαναφορά κωδικού», μπορεί να σας δώσει νέο κωδικό πρόσβασης. Οι συνεδρίες και οι βαθμολογίες σας διατηρούνται.</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Όνομα χρήστη</translation>
    </message>
    <message>
        <source>Recovery code</source>
        <translation>Κωδικός ανάκτησης</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Πίσω</translation>
    </message>
    <message>
        <source>Set the password</source>
        <translation>Ορισμός κωδικού</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Έλεγχος …</translation>
    </message>
    <message>
        <source>Administrators can use their recovery code. It was shown when the site was set up, or when they made one under My account.</source>
        <translation>Οι διαχειριστές μπορούν να χρησιμοποιήσουν τον κωδικό ανάκτησής τους. Εμφανίστηκε όταν στήθηκε το κέντρο ή όταν τον δημιούργησαν στο «Ο λογαριασμός μου».</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ResetPasswordDialog</name>
    <message>
        <source>New password for %1</source>
        <translation>Νέος κωδικός πρόσβασης για %1</translation>
    </message>
    <message>
        <source>The current password stops working at once. Sessions and scores are kept.</source>
        <translation>Ο τωρινός κωδικός παύει αμέσως να ισχύει. Οι συνεδρίες και οι βαθμολογίες διατηρούνται.</translation>
    </message>
    <message>
        <source>Set the password</source>
        <translation>Ορισμός κωδικού</translation>
    </message>
    <message>
        <source>The password of %1 was not changed.
%2</source>
        <translation>Ο κωδικός πρόσβασης δεν άλλαξε: %1.
%2</translation>
    </message>
    <message>
        <source>%1 has a new password.</source>
        <translation>Νέος κωδικός πρόσβασης ορίστηκε για %1.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RestoreDialog</name>
    <message>
        <source>Restore a backup</source>
        <translation>Επαναφορά αντιγράφου ασφαλείας</translation>
    </message>
    <message>
        <source>Go back to the backup made %1?</source>
        <translation>Επιστροφή στο αντίγραφο ασφαλείας που έγινε %1;</translation>
    </message>
    <message>
        <source>Everything recorded after this backup is removed from view. The current database is kept as a copy; nothing is deleted. People who were erased stay erased. Everybody is logged out.</source>
        <translation>Όσα καταγράφηκαν μετά από αυτό το αντίγραφο δεν θα εμφανίζονται πια. Η τωρινή βάση δεδομένων φυλάσσεται ως αντίγραφο· τίποτα δεν διαγράφεται. Όσα άτομα διαγράφηκαν μένουν διαγραμμένα. Όλοι αποσυνδέονται.</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>Διαχειριστής/-τρια</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Κωδικός πρόσβασης</translation>
    </message>
    <message>
        <source>The backup has a different administrator or password</source>
        <translation>Το αντίγραφο έχει άλλον διαχειριστή ή κωδικό πρόσβασης</translation>
    </message>
    <message>
        <source>Keep the current database</source>
        <translation>Διατήρηση της τωρινής βάσης</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Επαναφορά</translation>
    </message>
    <message>
        <source>The site becomes what it was when this backup was made. The damaged file is kept as a copy; nothing is deleted. People who were erased stay erased. An administrator of the backup has to agree.</source>
        <translation>Το κέντρο γίνεται όπως ήταν όταν δημιουργήθηκε αυτό το αντίγραφο. Το κατεστραμμένο αρχείο φυλάσσεται ως αντίγραφο· τίποτα δεν διαγράφεται. Όσα άτομα διαγράφηκαν μένουν διαγραμμένα. Πρέπει να συμφωνήσει ένας διαχειριστής του αντιγράφου.</translation>
    </message>
    <message>
        <source>The site becomes what it was when this backup was made. People who were erased stay erased. An administrator of the backup has to agree.</source>
        <translation>Το κέντρο γίνεται όπως ήταν όταν δημιουργήθηκε αυτό το αντίγραφο. Όσα άτομα διαγράφηκαν μένουν διαγραμμένα. Πρέπει να συμφωνήσει ένας διαχειριστής του αντιγράφου.</translation>
    </message>
    <message>
        <source>The damaged file has a different administrator or password</source>
        <translation>Το κατεστραμμένο αρχείο έχει άλλον διαχειριστή ή κωδικό πρόσβασης</translation>
    </message>
    <message>
        <source>Administrator in the damaged file</source>
        <translation>Διαχειριστής στο κατεστραμμένο αρχείο</translation>
    </message>
    <message>
        <source>Password in the damaged file</source>
        <translation>Κωδικός πρόσβασης στο κατεστραμμένο αρχείο</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Άκυρο</translation>
    </message>
    <message>
        <source>The backup has a different administrator or password. Enter those of the backup, too.</source>
        <translation>Το αντίγραφο ασφαλείας έχει άλλον διαχειριστή ή άλλον κωδικό πρόσβασης. Δώστε και τα στοιχεία του αντιγράφου.</translation>
    </message>
    <message>
        <source>The damaged file has a different administrator or password. Enter those, too.</source>
        <translation>Το κατεστραμμένο αρχείο έχει άλλον διαχειριστή ή άλλον κωδικό πρόσβασης. Δώστε και τα στοιχεία του αρχείου.</translation>
    </message>
    <message>
        <source>A backup keeps the login names and passwords of the day it was made. If yours have been changed since, enter the earlier ones.</source>
        <translation>Ένα αντίγραφο ασφαλείας κρατά τα ονόματα χρήστη και τους κωδικούς πρόσβασης της ημέρας που έγινε. Αν τα δικά σας έχουν αλλάξει από τότε, δώστε τα προηγούμενα.</translation>
    </message>
    <message>
        <source>The damaged file still has the login names and passwords of its last day. Where they can be read, one of its administrators has to agree, so that nobody puts an old backup in its place without permission.</source>
        <translation>Το κατεστραμμένο αρχείο έχει ακόμη τα ονόματα χρήστη και τους κωδικούς πρόσβασης της τελευταίας του ημέρας. Όπου διαβάζονται, πρέπει να συμφωνήσει ένας διαχειριστής του, ώστε κανείς να μη βάλει χωρίς άδεια ένα παλιό αντίγραφο στη θέση του.</translation>
    </message>
    <message>
        <source>Your login name when this backup was made</source>
        <translation>Το όνομα χρήστη σας όταν έγινε αυτό το αντίγραφο</translation>
    </message>
    <message>
        <source>Your password when this backup was made</source>
        <translation>Ο κωδικός πρόσβασής σας όταν έγινε αυτό το αντίγραφο</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RestoreScreen</name>
    <message>
        <source>Backups</source>
        <translation>Αντίγραφα ασφαλείας</translation>
    </message>
    <message>
        <source>Looking for backups …</source>
        <translation>Αναζήτηση αντιγράφων ασφαλείας …</translation>
    </message>
    <message>
        <source>The site&apos;s file is missing</source>
        <translation>Το αρχείο του κέντρου λείπει</translation>
    </message>
    <message>
        <source>The site&apos;s file is damaged</source>
        <translation>Το αρχείο του κέντρου είναι κατεστραμμένο</translation>
    </message>
    <message>
        <source>Everything of a site is in one file. If that is damaged or gone, a backup brings the site back as it was when the backup was made.

The list shows the backups in the places that this computer knows, newest first, and whether each can be used. Use &quot;Choose a file&quot; for one on another disk: it is a folder with the files manifest.json and chiron.db in it.

An administrator of the backup has to give the password. The damaged file is never deleted: it is kept beside the new one under another name.</source>
        <translation>Όλα όσα ανήκουν σε ένα κέντρο βρίσκονται σε ένα αρχείο. Αν αυτό καταστραφεί ή χαθεί, ένα αντίγραφο ασφαλείας επαναφέρει το κέντρο όπως ήταν όταν δημιουργήθηκε το αντίγραφο.

Η λίστα δείχνει τα αντίγραφα στις θέσεις που γνωρίζει αυτός ο υπολογιστής, πρώτα το νεότερο, και αν μπορεί να χρησιμοποιηθεί το καθένα. Με το «Επιλογή αρχείου» παίρνετε ένα από άλλον δίσκο: είναι ένας φάκελος με τα αρχεία manifest.json και chiron.db.

Ένας διαχειριστής του αντιγράφου πρέπει να δώσει τον κωδικό πρόσβασης. Το κατεστραμμένο αρχείο δεν διαγράφεται ποτέ: φυλάσσεται δίπλα στο νέο με άλλο όνομα.</translation>
    </message>
    <message>
        <source>%1 is no longer there. If it was moved, or is on a disk that is not connected, put it back and try again. Otherwise restore a backup.</source>
        <translation>Το %1 δεν υπάρχει πια. Αν μετακινήθηκε ή βρίσκεται σε δίσκο που δεν είναι συνδεδεμένος, βάλτε το στη θέση του και δοκιμάστε ξανά. Αλλιώς επαναφέρετε ένα αντίγραφο ασφαλείας.</translation>
    </message>
    <message>
        <source>%1 cannot be read as a site. Nothing was changed. Restore a backup to continue; the damaged file is kept as a copy.</source>
        <translation>Το %1 δεν μπορεί να διαβαστεί ως κέντρο. Τίποτα δεν άλλαξε. Για να συνεχίσετε, επαναφέρετε ένα αντίγραφο ασφαλείας· το κατεστραμμένο αρχείο φυλάσσεται ως αντίγραφο.</translation>
    </message>
    <message>
        <source>Details: %1</source>
        <translation>Λεπτομέρειες: %1</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Δημιουργία</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Παλαιότητα</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Μέγεθος</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Είδος</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Κατάσταση</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Φάκελος</translation>
    </message>
    <message>
        <source>Restore the selected backup …</source>
        <translation>Επαναφορά αντιγράφου …</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Επιλογή αρχείου …</translation>
    </message>
    <message>
        <source>Try to open it again</source>
        <translation>Νέα προσπάθεια ανοίγματος</translation>
    </message>
    <message>
        <source>Set up a new site</source>
        <translation>Δημιουργία νέου κέντρου</translation>
    </message>
    <message>
        <source>Wait until the restore has finished.</source>
        <translation>Περιμένετε να τελειώσει η επαναφορά.</translation>
    </message>
    <message>
        <source>No backup was found</source>
        <translation>Δεν βρέθηκε αντίγραφο ασφαλείας</translation>
    </message>
    <message>
        <source>There is none in %1. If you have one elsewhere, on a USB drive or on the network, choose it below.</source>
        <translation>Δεν υπάρχει κανένα στο %1. Αν έχετε ένα αλλού, σε μονάδα USB ή στο δίκτυο, επιλέξτε το παρακάτω.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Αυτόματο</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Χειροκίνητο</translation>
    </message>
    <message>
        <source>Being checked …</source>
        <translation>Ελέγχεται …</translation>
    </message>
    <message>
        <source>Intact</source>
        <translation>Ακέραιο</translation>
    </message>
    <message>
        <source>Cannot be used</source>
        <translation>Δεν μπορεί να χρησιμοποιηθεί</translation>
    </message>
    <message>
        <source>No backup is selected.</source>
        <translation>Δεν έχει επιλεγεί αντίγραφο ασφαλείας.</translation>
    </message>
    <message>
        <source>This backup cannot be used.</source>
        <translation>Αυτό το αντίγραφο ασφαλείας δεν μπορεί να χρησιμοποιηθεί.</translation>
    </message>
    <message>
        <source>A file of the backup</source>
        <translation>Ένα αρχείο του αντιγράφου ασφαλείας</translation>
    </message>
    <message>
        <source>Backups (manifest.json chiron.db)</source>
        <translation>Αντίγραφα ασφαλείας (manifest.json chiron.db)</translation>
    </message>
    <message>
        <source>%1 is not a backup. A backup is a folder with the files manifest.json and chiron.db in it.</source>
        <translation>Το %1 δεν είναι αντίγραφο ασφαλείας. Ένα αντίγραφο ασφαλείας είναι ένας φάκελος με τα αρχεία manifest.json και chiron.db.</translation>
    </message>
    <message>
        <source>Restoring the backup and checking it …</source>
        <translation>Επαναφορά και έλεγχος του αντιγράφου ασφαλείας …</translation>
    </message>
    <message>
        <source>Nothing was restored: the name or the password is not that of an administrator, or too many wrong ones were given.
Details: %1</source>
        <translation>Δεν έγινε επαναφορά: το όνομα ή ο κωδικός πρόσβασης δεν ανήκει σε διαχειριστή, ή δόθηκαν πολλές φορές λανθασμένα.
Λεπτομέρειες: %1</translation>
    </message>
    <message>
        <source>Nothing was restored.</source>
        <translation>Δεν έγινε επαναφορά.</translation>
    </message>
    <message>
        <source>Nothing was restored. The damaged file is unchanged.</source>
        <translation>Δεν έγινε επαναφορά. Το κατεστραμμένο αρχείο έμεινε όπως ήταν.</translation>
    </message>
    <message>
        <source>The backup was restored. Please log in.</source>
        <translation>Το αντίγραφο ασφαλείας επαναφέρθηκε. Παρακαλούμε συνδεθείτε.</translation>
    </message>
    <message>
        <source>The backup was restored. The damaged file is kept as %1. Please log in.</source>
        <translation>Το αντίγραφο ασφαλείας επαναφέρθηκε. Το κατεστραμμένο αρχείο φυλάσσεται ως %1. Παρακαλούμε συνδεθείτε.</translation>
    </message>
    <message>
        <source>%1 is still missing.</source>
        <translation>Το %1 εξακολουθεί να λείπει.</translation>
    </message>
    <message>
        <source>The key of this site is missing, too: %1. Without it no backup can be checked or restored. Put it back from a copy of the site&apos;s folder, then try again.</source>
        <translation>Λείπει και το κλειδί αυτού του κέντρου: %1. Χωρίς αυτό κανένα αντίγραφο ασφαλείας δεν μπορεί να ελεγχθεί ή να επαναφερθεί. Επαναφέρετέ το από ένα αντίγραφο του φακέλου του κέντρου και δοκιμάστε ξανά.</translation>
    </message>
    <message>
        <source>This backup cannot be used.
Details: %1</source>
        <translation>Αυτό το αντίγραφο ασφαλείας δεν μπορεί να χρησιμοποιηθεί.
Λεπτομέρειες: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ResultsScreen</name>
    <message>
        <source>My results</source>
        <translation>Τα αποτελέσματά μου</translation>
    </message>
    <message>
        <source>Export my data</source>
        <translation>Εξαγωγή δεδομένων μου</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>Δεν υπάρχουν ακόμη αποτελέσματα</translation>
    </message>
    <message>
        <source>Your first session will be here, with its scores and its playback.</source>
        <translation>Η πρώτη σας συνεδρία θα εμφανιστεί εδώ, με τις βαθμολογίες και την αναπαραγωγή της.</translation>
    </message>
    <message>
        <source>Choose an exercise</source>
        <translation>Επιλογή άσκησης</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Προσπάθειες</translation>
    </message>
    <message>
        <source>Open the attempt</source>
        <translation>Άνοιγμα προσπάθειας</translation>
    </message>
    <message>
        <source>Your data</source>
        <translation>Τα δεδομένα σας</translation>
    </message>
    <message>
        <source>A copy of everything that is held about you: your account, sessions, scores, comments and samples. It is yours to keep; nothing is removed here.</source>
        <translation>Αντίγραφο όλων των στοιχείων που υπάρχουν για εσάς: λογαριασμός, συνεδρίες, βαθμολογίες, σχόλια και δείγματα. Είναι δικό σας· τίποτα δεν αφαιρείται από εδώ.</translation>
    </message>
    <message>
        <source>Export my data …</source>
        <translation>Εξαγωγή δεδομένων μου …</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Άσκηση</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Επίπεδο</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Μέτρηση</translation>
    </message>
    <message>
        <source>Choose a folder for your data</source>
        <translation>Επιλογή φακέλου για τα δεδομένα σας</translation>
    </message>
    <message>
        <source>Writing your data …</source>
        <translation>Αποθήκευση των δεδομένων σας …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Άκυρο</translation>
    </message>
    <message>
        <source>Your data was written to %1.</source>
        <translation>Τα δεδομένα σας αποθηκεύτηκαν στο %1.</translation>
    </message>
    <message>
        <source>Your data could not be written completely.</source>
        <translation>Τα δεδομένα σας δεν αποθηκεύτηκαν πλήρως.</translation>
    </message>
    <message>
        <source>Results of %1</source>
        <translation>Αποτελέσματα: %1</translation>
    </message>
    <message>
        <source>The results could not be read</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση των αποτελεσμάτων</translation>
    </message>
    <message>
        <source>Reading the results …</source>
        <translation>Ανάγνωση των αποτελεσμάτων …</translation>
    </message>
    <message>
        <source>Nothing was recorded for this person.</source>
        <translation>Δεν υπάρχουν καταγραφές για αυτό το άτομο.</translation>
    </message>
    <message>
        <source>All sessions of this person</source>
        <translation>Όλες οι συνεδρίες του ατόμου</translation>
    </message>
    <message>
        <source>The results of one person.

Choose an exercise, a level and a metric. The curve has a point for each completed attempt; attempts with felt force and attempts with force shown only are never compared. Press Enter or double-click to open an attempt.</source>
        <translation>Τα αποτελέσματα ενός ατόμου.

Επιλέξτε άσκηση, επίπεδο και μέτρηση. Η καμπύλη έχει ένα σημείο για κάθε ολοκληρωμένη προσπάθεια· προσπάθειες με αισθητή δύναμη και προσπάθειες με δύναμη που μόνο προβάλλεται δεν συγκρίνονται ποτέ. Με Enter ή διπλό κλικ ανοίγει μια προσπάθεια.</translation>
    </message>
    <message>
        <source>All your sessions, and your progress.

Choose an exercise, a level and a metric. The curve has a point for each completed attempt. Attempts with felt force and attempts with force shown only have separate lines and are never compared. The horizontal line is the pass mark; the band shows what others reached.

Press Enter or double-click to open an attempt. &quot;Export my data&quot; writes everything that is stored about you to a folder of your choice.</source>
        <translation>Όλες οι συνεδρίες σας και η πρόοδός σας.

Επιλέξτε άσκηση, επίπεδο και μέτρηση. Η καμπύλη έχει ένα σημείο για κάθε ολοκληρωμένη προσπάθεια· η αισθητή δύναμη και η δύναμη που μόνο προβάλλεται έχουν ξεχωριστές γραμμές και δεν συγκρίνονται ποτέ. Η οριζόντια γραμμή είναι το όριο επιτυχίας· η ζώνη δείχνει τι πέτυχαν άλλοι.

Το Enter ή το διπλό κλικ ανοίγει μια προσπάθεια. Η «Εξαγωγή δεδομένων μου» γράφει όλα τα στοιχεία που υπάρχουν για εσάς σε φάκελο της επιλογής σας.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RocBox</name>
    <message>
        <source>Confidence and accuracy (ROC)</source>
        <translation>Βεβαιότητα και ορθότητα (ROC)</translation>
    </message>
    <message>
        <source>Reading the recordings …</source>
        <translation>Ανάγνωση των καταγραφών …</translation>
    </message>
    <message>
        <source>The recordings could not be read</source>
        <translation>Οι καταγραφές δεν ήταν δυνατό να διαβαστούν</translation>
    </message>
    <message>
        <source>Not enough answers yet</source>
        <translation>Δεν υπάρχουν ακόμη αρκετές απαντήσεις</translation>
    </message>
    <message>
        <source>A curve needs at least %1 places with a lump and as many without. So far: %2 with, %3 without.</source>
        <translation>Μια καμπύλη χρειάζεται τουλάχιστον %1 θέσεις με όζο και άλλες τόσες χωρίς. Μέχρι τώρα: %2 με, %3 χωρίς.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RoleChoice</name>
    <message>
        <source>Trains and sees their own results</source>
        <translation>Εκπαιδεύεται και βλέπει τα δικά του αποτελέσματα</translation>
    </message>
    <message>
        <source>Roles (at least one)</source>
        <translation>Ρόλοι (τουλάχιστον ένας)</translation>
    </message>
    <message>
        <source>Designs studies and runs them with participants; sees sessions by code, without names</source>
        <translation>Σχεδιάζει μελέτες και τις διεξάγει με συμμετέχοντες· βλέπει συνεδρίες με ψευδώνυμο, χωρίς ονόματα</translation>
    </message>
    <message>
        <source>Manages people, storage and the station; may also design and run studies</source>
        <translation>Διαχειρίζεται άτομα, δεδομένα και σταθμό· μπορεί και να σχεδιάζει και να διεξάγει μελέτες</translation>
    </message>
    <message>
        <source>Sees everybody&apos;s sessions, and can comment on them and void them</source>
        <translation>Βλέπει τις συνεδρίες όλων, τις σχολιάζει και τις ακυρώνει</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RolesDialog</name>
    <message>
        <source>Roles of %1</source>
        <translation>Ρόλοι: %1</translation>
    </message>
    <message>
        <source>The change takes effect at once, even for people who are logged in.</source>
        <translation>Η αλλαγή ισχύει αμέσως, και για όποιον είναι συνδεδεμένος.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Αποθήκευση</translation>
    </message>
    <message>
        <source>The roles of %1 have been changed.</source>
        <translation>Οι ρόλοι άλλαξαν: %1.</translation>
    </message>
    <message>
        <source>%1 remains an administrator: a site needs at least one who can log in. Make another person an administrator first.</source>
        <translation>Παραμένει διαχειριστής: %1. Το κέντρο χρειάζεται τουλάχιστον έναν που μπορεί να συνδεθεί. Ορίστε πρώτα άλλο άτομο ως διαχειριστή.</translation>
    </message>
    <message>
        <source>The roles of %1 were not changed.
%2</source>
        <translation>Οι ρόλοι δεν άλλαξαν: %1.
%2</translation>
    </message>
    <message>
        <source>Your roles have been changed. The list on the left shows the screens that go with them.</source>
        <translation>Οι ρόλοι σας άλλαξαν. Η λίστα αριστερά δείχνει τις αντίστοιχες οθόνες.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RosterDialog</name>
    <message>
        <source>Import people</source>
        <translation>Εισαγωγή ατόμων</translation>
    </message>
    <message>
        <source>From %1. Nothing is changed before you press Import.</source>
        <translation>Από το %1. Τίποτα δεν αλλάζει πριν πατήσετε «Εισαγωγή».</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Εισαγωγή</translation>
    </message>
    <message>
        <source>Reading the list …</source>
        <translation>Ανάγνωση της λίστας …</translation>
    </message>
    <message>
        <source>The list could not be compared with the people on this site.</source>
        <translation>Δεν ήταν δυνατή η σύγκριση της λίστας με τα άτομα του κέντρου.</translation>
    </message>
    <message numerus="yes">
        <source>Import %n people</source>
        <translation>
            <numerusform>Εισαγωγή %n ατόμου</numerusform>
            <numerusform>Εισαγωγή %n ατόμων</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing can be imported yet: correct these lines in the file, then choose it again.</source>
        <translation>Η εισαγωγή δεν γίνεται ακόμη: διορθώστε αυτές τις γραμμές στο αρχείο και επιλέξτε το ξανά.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>και %n ακόμη</numerusform>
            <numerusform>και %n ακόμη</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people were added.</source>
        <translation>
            <numerusform>Προστέθηκε %n άτομο.</numerusform>
            <numerusform>Προστέθηκαν %n άτομα.</numerusform>
        </translation>
    </message>
    <message>
        <source>People who have an account already</source>
        <translation>Άτομα που έχουν ήδη λογαριασμό</translation>
    </message>
    <message>
        <source>Leave them as they are</source>
        <translation>Να μείνουν ως έχουν</translation>
    </message>
    <message>
        <source>Update full name and roles</source>
        <translation>Ενημέρωση ονόματος και ρόλων</translation>
    </message>
    <message>
        <source>Nothing can be imported from this file.</source>
        <translation>Από αυτό το αρχείο δεν μπορεί να εισαχθεί τίποτα.</translation>
    </message>
    <message>
        <source>Nothing was changed: the site needs at least one administrator who can log in, and the list would leave none.</source>
        <translation>Δεν άλλαξε τίποτα: το κέντρο χρειάζεται τουλάχιστον έναν διαχειριστή που μπορεί να συνδεθεί, και η λίστα δεν θα άφηνε κανέναν.</translation>
    </message>
    <message>
        <source>Nothing was changed.
%1</source>
        <translation>Δεν άλλαξε τίποτα.
%1</translation>
    </message>
    <message numerus="yes">
        <source>Importing %n people …</source>
        <translation>
            <numerusform>Εισαγωγή %n ατόμου …</numerusform>
            <numerusform>Εισαγωγή %n ατόμων …</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people were updated.</source>
        <translation>
            <numerusform>Ενημερώθηκε %n άτομο.</numerusform>
            <numerusform>Ενημερώθηκαν %n άτομα.</numerusform>
        </translation>
    </message>
    <message>
        <source>The slips have been neither printed nor saved. If you close this window again, the passwords are gone; you can then only set new ones, one by one.</source>
        <translation>Τα σημειώματα ούτε τυπώθηκαν ούτε αποθηκεύτηκαν. Αν κλείσετε ξανά αυτό το παράθυρο, οι κωδικοί πρόσβασης χάνονται· μετά μπορείτε μόνο να ορίσετε νέους, έναν έναν.</translation>
    </message>
    <message>
        <source>The list has words that are not roles here. Choose what each of them stands for, or correct the file.</source>
        <translation>Ο κατάλογος έχει λέξεις που δεν είναι ρόλοι εδώ. Επιλέξτε τι σημαίνει η καθεμία ή διορθώστε το αρχείο.</translation>
    </message>
    <message>
        <source>No role is given</source>
        <translation>Δεν δίνεται ρόλος</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>«%1»</translation>
    </message>
    <message>
        <source>Role that %1 stands for</source>
        <translation>Ρόλος που σημαίνει: %1</translation>
    </message>
    <message>
        <source>Choose a role …</source>
        <translation>Επιλέξτε ρόλο …</translation>
    </message>
    <message>
        <source>Nothing can be imported yet: choose above what the words stand for, or correct these lines in the file and choose it again.</source>
        <translation>Η εισαγωγή δεν γίνεται ακόμη: επιλέξτε παραπάνω τι σημαίνουν οι λέξεις ή διορθώστε αυτές τις γραμμές στο αρχείο και επιλέξτε το ξανά.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RulesPage</name>
    <message>
        <source>Trials and breaks</source>
        <translation>Δοκιμές και διαλείμματα</translation>
    </message>
    <message>
        <source>Rules of a trial</source>
        <translation>Κανόνες μίας δοκιμής</translation>
    </message>
    <message>
        <source>Time to explore</source>
        <translation>Χρόνος εξερεύνησης</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>χωρίς όριο</translation>
    </message>
    <message>
        <source>A trial without a mark ends after this time; 0: never.</source>
        <translation>Μια δοκιμή χωρίς σημείο τελειώνει μετά από αυτόν τον χρόνο· 0: ποτέ.</translation>
    </message>
    <message>
        <source>The objects go away after this time; 0: never.</source>
        <translation>Μετά από αυτόν τον χρόνο τα αντικείμενα εξαφανίζονται· 0: ποτέ.</translation>
    </message>
    <message>
        <source>Time to answer</source>
        <translation>Χρόνος απάντησης</translation>
    </message>
    <message>
        <source>Between trials</source>
        <translation>Ανάμεσα σε δοκιμές</translation>
    </message>
    <message>
        <source>Time until the next objects come.</source>
        <translation>Χρόνος ώσπου να έρθουν τα επόμενα αντικείμενα.</translation>
    </message>
    <message>
        <source>Practice trials</source>
        <translation>Δοκιμές εξάσκησης</translation>
    </message>
    <message>
        <source>Participants rest before they go on; 0: never.</source>
        <translation>Οι συμμετέχοντες ξεκουράζονται πριν συνεχίσουν· 0: ποτέ.</translation>
    </message>
    <message>
        <source>Shortest break</source>
        <translation>Ελάχιστο διάλειμμα</translation>
    </message>
    <message>
        <source>Participants go on after this time at the earliest.</source>
        <translation>Οι συμμετέχοντες συνεχίζουν το νωρίτερο μετά από αυτόν τον χρόνο.</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Ανατροφοδότηση</translation>
    </message>
    <message>
        <source>Participants are told after each trial how well they did. This feedback changes what is measured.</source>
        <translation>Οι συμμετέχοντες μαθαίνουν μετά από κάθε δοκιμή πόσο καλά τα πήγαν. Αυτό αλλάζει ό,τι μετριέται.</translation>
    </message>
    <message>
        <source>Masking sound</source>
        <translation>Ήχος κάλυψης</translation>
    </message>
    <message>
        <source>Show the objects</source>
        <translation>Εμφάνιση αντικειμένων</translation>
    </message>
    <message>
        <source>Objects are drawn, all alike, so that only touch tells them apart.</source>
        <translation>Τα αντικείμενα σχεδιάζονται όλα ίδια, ώστε να τα ξεχωρίζει μόνο η αφή.</translation>
    </message>
    <message>
        <source>Every object must be touched</source>
        <translation>Να αγγιχτεί κάθε αντικείμενο</translation>
    </message>
    <message>
        <source>An answer is accepted only once each object has been touched.</source>
        <translation>Η απάντηση γίνεται δεκτή μόνο αφού αγγιχτεί κάθε αντικείμενο.</translation>
    </message>
    <message>
        <source>Instructions</source>
        <translation>Οδηγίες</translation>
    </message>
    <message>
        <source>Your own sentences</source>
        <translation>Οι δικές σας προτάσεις</translation>
    </message>
    <message>
        <source>What to do, and how to hold the instrument. Leave out time, trials, feedback and breaks: those sentences are made from the settings and always fit them.</source>
        <translation>Τι πρέπει να γίνει και πώς κρατιέται το εργαλείο. Παραλείψτε χρόνο, δοκιμές, ανατροφοδότηση και διαλείμματα: αυτές οι προτάσεις προκύπτουν από τις ρυθμίσεις και τους ταιριάζουν πάντα.</translation>
    </message>
    <message>
        <source>These instructions were written before the program made sentences from the settings. Remove what those sentences now say.</source>
        <translation>Οι οδηγίες αυτές γράφτηκαν πριν το πρόγραμμα αρχίσει να σχηματίζει προτάσεις από τις ρυθμίσεις. Αφαιρέστε όσα λένε πλέον αυτές οι προτάσεις.</translation>
    </message>
    <message>
        <source>What participants read</source>
        <translation>Τι διαβάζουν οι συμμετέχοντες</translation>
    </message>
    <message>
        <source>Order and blinding</source>
        <translation>Σειρά και τυφλότητα</translation>
    </message>
    <message>
        <source>Blinding</source>
        <translation>Τυφλότητα</translation>
    </message>
    <message>
        <source>Order of conditions</source>
        <translation>Σειρά των συνθηκών</translation>
    </message>
    <message>
        <source>Blind participants</source>
        <translation>Τυφλότητα συμμετεχόντων</translation>
    </message>
    <message>
        <source>Participants see no values and no names of conditions.</source>
        <translation>Οι συμμετέχοντες δεν βλέπουν τιμές ούτε ονόματα συνθηκών.</translation>
    </message>
    <message>
        <source>Blind experimenters</source>
        <translation>Τυφλότητα πειραματιστών</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Σπόρος</translation>
    </message>
    <message>
        <source>Fidelity of a trial</source>
        <translation>Πιστότητα μίας δοκιμής</translation>
    </message>
    <message>
        <source>A trial outside these limits is not scored and is presented again.</source>
        <translation>Μια δοκιμή εκτός αυτών των ορίων δεν βαθμολογείται και επαναλαμβάνεται.</translation>
    </message>
    <message>
        <source>Limits of fidelity</source>
        <translation>Όρια πιστότητας</translation>
    </message>
    <message>
        <source>Force error</source>
        <translation>Σφάλμα δύναμης</translation>
    </message>
    <message>
        <source>Error of the felt value</source>
        <translation>Σφάλμα της αισθητής τιμής</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Καθυστερημένοι κύκλοι</translation>
    </message>
    <message>
        <source>Share of the force&apos;s updates that may come too late.</source>
        <translation>Ποσοστό ενημερώσεων της δύναμης που μπορούν να καθυστερήσουν.</translation>
    </message>
    <message>
        <source>Force at its limit</source>
        <translation>Δύναμη στο όριο</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Μέγιστη δύναμη</translation>
    </message>
    <message>
        <source>How hard a participant may press.</source>
        <translation>Πόσο δυνατά μπορεί να πιέζει ένα άτομο.</translation>
    </message>
    <message>
        <source>Mean speed</source>
        <translation>Μέση ταχύτητα</translation>
    </message>
    <message>
        <source>How fast a participant may move, on average.</source>
        <translation>Πόσο γρήγορα μπορεί να κινείται ένα άτομο κατά μέσο όρο.</translation>
    </message>
    <message>
        <source>Repeats of one trial</source>
        <translation>Επαναλήψεις μίας δοκιμής</translation>
    </message>
    <message>
        <source>Smallest force on an object</source>
        <translation>Μικρότερη δύναμη σε ένα αντικείμενο</translation>
    </message>
    <message>
        <source>any touch</source>
        <translation>κάθε άγγιγμα</translation>
    </message>
    <message>
        <source>A steady noise hides the sounds of the device. Participants are told of it where it is heard.</source>
        <translation>Ένας σταθερός θόρυβος καλύπτει τους ήχους της συσκευής. Οι συμμετέχοντες ενημερώνονται όπου ακούγεται.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: enter a whole number from 0 to %2.</source>
        <translation>Το «%1» δεν έγινε δεκτό: πληκτρολογήστε ακέραιο αριθμό από 0 έως %2.</translation>
    </message>
    <message>
        <source>Trials between breaks</source>
        <translation>Δοκιμές μεταξύ διαλειμμάτων</translation>
    </message>
    <message>
        <source>A whole number from which all orders and random choices are drawn: the same number gives the same study again.</source>
        <translation>Ακέραιος από τον οποίο προκύπτουν όλες οι σειρές και οι τυχαίες επιλογές: ο ίδιος αριθμός δίνει ξανά την ίδια μελέτη.</translation>
    </message>
    <message>
        <source>How far the rendered value may be from the requested one.</source>
        <translation>Πόσο μπορεί να απέχει η τιμή που αποδόθηκε από εκείνη που ζητήθηκε.</translation>
    </message>
    <message>
        <source>Share of the contact time during which the device may be at its force limit.</source>
        <translation>Ποσοστό του χρόνου επαφής κατά το οποίο η συσκευή μπορεί να βρίσκεται στο όριο δύναμής της.</translation>
    </message>
    <message>
        <source>After this many repeats the run pauses and asks the experimenter.</source>
        <translation>Μετά από τόσες επαναλήψεις η εκτέλεση σταματά και ρωτά τον πειραματιστή.</translation>
    </message>
    <message>
        <source>Time to answer once the objects are gone. Without an answer the trial is repeated. 0: no limit.</source>
        <translation>Χρόνος απάντησης αφού εξαφανιστούν τα αντικείμενα. Χωρίς απάντηση η δοκιμή επαναλαμβάνεται. 0: χωρίς όριο.</translation>
    </message>
    <message>
        <source>Trials before each condition, at the largest difference and with feedback. They are never scored.</source>
        <translation>Δοκιμές πριν από κάθε συνθήκη, με τη μεγαλύτερη διαφορά και με ανατροφοδότηση. Δεν βαθμολογούνται ποτέ.</translation>
    </message>
    <message>
        <source>An object counts as touched only once it was pressed, pulled or lifted with this force, so that nobody answers after barely touching it. 0: any touch counts.</source>
        <translation>Το άγγιγμα ενός αντικειμένου μετράει μόνο όταν αυτό πιέστηκε, τραβήχτηκε ή σηκώθηκε με αυτή τη δύναμη, ώστε κανείς να μην απαντά μετά από μια φευγαλέα επαφή. 0: μετράει κάθε άγγιγμα.</translation>
    </message>
    <message>
        <source>In which order each participant does the conditions. A Williams design also balances which condition follows which.</source>
        <translation>Με ποια σειρά κάνει κάθε συμμετέχων τις συνθήκες. Ένα σχέδιο Williams εξισορροπεί και ποια συνθήκη ακολουθεί ποια.</translation>
    </message>
    <message>
        <source>Until the study is unblinded, experimenters see sealed codes instead of the conditions.</source>
        <translation>Ως την άρση της τυφλότητας οι πειραματιστές βλέπουν σφραγισμένους κωδικούς αντί για τις συνθήκες.</translation>
    </message>
    <message>
        <source>How far the measured force may be from the commanded one (root mean square).</source>
        <translation>Πόσο μπορεί να απέχει η μετρημένη δύναμη από τη ζητούμενη (τετραγωνικός μέσος).</translation>
    </message>
    <message>
        <source>%1: as many trials as the answers need</source>
        <translation>%1: όσες δοκιμές απαιτούν οι απαντήσεις</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n trial(s) that count</source>
        <translation>
            <numerusform>%1: %n δοκιμή που μετράει</numerusform>
            <numerusform>%1: %n δοκιμές που μετράνε</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: at most %n trial(s) that count</source>
        <translation>
            <numerusform>%1: το πολύ %n δοκιμή που μετράει</numerusform>
            <numerusform>%1: το πολύ %n δοκιμές που μετράνε</numerusform>
        </translation>
    </message>
    <message>
        <source>Number of trials</source>
        <translation>Αριθμός δοκιμών</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Εμφάνιση</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Αλλαγή</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>Αλλαγή: %1</translation>
    </message>
    <message>
        <source>The procedure of each condition sets this number, on the page Conditions. Practice and repeated trials are not included.</source>
        <translation>Τον αριθμό αυτόν τον ορίζει η διαδικασία κάθε συνθήκης, στη σελίδα «Συνθήκες». Οι δοκιμές εξάσκησης και οι επαναλήψεις δεν περιλαμβάνονται.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RunScreen</name>
    <message>
        <source>Run</source>
        <translation>Διεξαγωγή</translation>
    </message>
    <message>
        <source>Reading the studies …</source>
        <translation>Ανάγνωση των μελετών …</translation>
    </message>
    <message>
        <source>The studies could not be read</source>
        <translation>Οι μελέτες δεν διαβάστηκαν</translation>
    </message>
    <message>
        <source>No study can be run yet</source>
        <translation>Καμία μελέτη δεν μπορεί να διεξαχθεί ακόμη</translation>
    </message>
    <message>
        <source>A study can be run as soon as its design is frozen and participants are enrolled.</source>
        <translation>Μια μελέτη μπορεί να διεξαχθεί αφού οριστικοποιηθεί το σχέδιό της και εγγραφούν συμμετέχοντες.</translation>
    </message>
    <message>
        <source>Open the studies</source>
        <translation>Άνοιγμα μελετών</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Μελέτη</translation>
    </message>
    <message>
        <source>Participant, by code</source>
        <translation>Συμμετέχων, με κωδικό</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Nobody is enrolled yet.</source>
        <translation>Κανείς δεν έχει εγγραφεί ακόμη.</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Αρχή</translation>
    </message>
    <message>
        <source>answered</source>
        <translation>απαντήθηκε</translation>
    </message>
    <message>
        <source>not answered yet</source>
        <translation>δεν απαντήθηκε ακόμη</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Απάντηση</translation>
    </message>
    <message>
        <source>Answer %1</source>
        <translation>Απάντηση: %1</translation>
    </message>
    <message>
        <source>Begin %1</source>
        <translation>Έναρξη: %1</translation>
    </message>
    <message>
        <source>Resume here</source>
        <translation>Συνέχεια από εδώ</translation>
    </message>
    <message>
        <source>Resume %1 where it was interrupted</source>
        <translation>Συνέχεια για %1 από το σημείο διακοπής</translation>
    </message>
    <message>
        <source>Other interrupted runs</source>
        <translation>Άλλες εκτελέσεις που διακόπηκαν</translation>
    </message>
    <message>
        <source>Takes a participant through a study.

Choose the study and the participant&apos;s code. The conditions appear in the participant&apos;s own order; if the experimenter is blinded, they appear under sealed codes. The questionnaires before and after the runs are answered here, too, and those about a condition once it is done.

An interrupted run resumes at the trial where it stopped.</source>
        <translation>Οδηγεί έναν συμμετέχοντα σε μια μελέτη.

Επιλέξτε τη μελέτη και τον κωδικό του συμμετέχοντα. Οι συνθήκες εμφανίζονται με τη δική του σειρά· αν ο πειραματιστής είναι τυφλός, φέρουν σφραγισμένους κωδικούς. Εδώ απαντώνται και τα ερωτηματολόγια πριν και μετά τις εκτελέσεις, και όσα αφορούν μια συνθήκη μόλις αυτή ολοκληρωθεί.

Μια εκτέλεση που διακόπηκε συνεχίζεται από τη δοκιμή όπου σταμάτησε.</translation>
    </message>
    <message>
        <source>This study plays a masking sound, and this machine has no sound output: participants would hear the device. Connect headphones or loudspeakers and open this page again. You can also go on: each trial is then recorded as not masked.</source>
        <translation>Αυτή η μελέτη παίζει ήχο κάλυψης και αυτός ο υπολογιστής δεν έχει έξοδο ήχου: οι συμμετέχοντες θα άκουγαν τη συσκευή. Συνδέστε ακουστικά ή ηχεία και ανοίξτε ξανά αυτή τη σελίδα. Μπορείτε και να συνεχίσετε: τότε κάθε δοκιμή καταγράφεται ως χωρίς κάλυψη.</translation>
    </message>
    <message>
        <source>%1, about condition %2</source>
        <translation>%1, για τη συνθήκη %2</translation>
    </message>
    <message>
        <source>Consent is missing. Nothing can start before it is recorded.</source>
        <translation>Λείπει η συγκατάθεση. Πριν καταγραφεί, τίποτα δεν μπορεί να αρχίσει.</translation>
    </message>
    <message>
        <source>Record the consent …</source>
        <translation>Καταγραφή συγκατάθεσης …</translation>
    </message>
    <message>
        <source>Enrol the next participant …</source>
        <translation>Εγγραφή επόμενου συμμετέχοντα …</translation>
    </message>
    <message>
        <source>Enrol somebody …</source>
        <translation>Εγγραφή συμμετέχοντα …</translation>
    </message>
    <message>
        <source>Go on with %1</source>
        <translation>Συνέχεια με %1</translation>
    </message>
    <message>
        <source>%1 has nothing left to do.</source>
        <translation>Για %1 δεν απομένει τίποτα.</translation>
    </message>
    <message>
        <source>%1 comes next and is selected.</source>
        <translation>Ακολουθεί %1, και έχει επιλεγεί.</translation>
    </message>
    <message>
        <source>%1 has nothing left to do. %2 comes next.</source>
        <translation>Για %1 δεν απομένει τίποτα. Ακολουθεί %2.</translation>
    </message>
    <message>
        <source>Nobody who is enrolled has anything left to do. Enrol the next participant.</source>
        <translation>Για κανέναν εγγεγραμμένο δεν απομένει τίποτα. Εγγράψτε το επόμενο άτομο.</translation>
    </message>
    <message>
        <source>Nobody who is enrolled has anything left to do.</source>
        <translation>Για κανέναν εγγεγραμμένο δεν απομένει τίποτα.</translation>
    </message>
    <message>
        <source>Sequence in each condition: %1.</source>
        <translation>Σειρά σε κάθε συνθήκη: %1.</translation>
    </message>
    <message>
        <source>If %1 does not come back, go on with somebody else. The trials that were done are kept, and count if they suffice for a value. The run can be resumed later. To take %1 out of the study, withdraw them on the study&apos;s page of participants.</source>
        <translation>Αν δεν επιστρέψει το άτομο με κωδικό %1, συνεχίστε με κάποιο άλλο. Οι δοκιμές που έγιναν διατηρούνται και μετρούν, αν επαρκούν για μια τιμή. Η εκτέλεση μπορεί να συνεχιστεί αργότερα. Για να φύγει το %1 από τη μελέτη, αποσύρετέ το στη σελίδα συμμετεχόντων της μελέτης.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::Scrubber</name>
    <message>
        <source>Position in the recording</source>
        <translation>Θέση στην καταγραφή</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionFilterBar</name>
    <message>
        <source>Search in the list</source>
        <translation>Αναζήτηση στη λίστα</translation>
    </message>
    <message>
        <source>Search: person, exercise, number</source>
        <translation>Άτομο, άσκηση, αριθμός</translation>
    </message>
    <message>
        <source>Include archived</source>
        <translation>Και αρχειοθετημένες</translation>
    </message>
    <message>
        <source>Clear the filters</source>
        <translation>Καθαρισμός φίλτρων</translation>
    </message>
    <message>
        <source>Everybody</source>
        <translation>Όλα τα άτομα</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Άτομο</translation>
    </message>
    <message>
        <source>All exercises</source>
        <translation>Όλες οι ασκήσεις</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Άσκηση</translation>
    </message>
    <message>
        <source>All levels</source>
        <translation>Όλα τα επίπεδα</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Επίπεδο</translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation>Επίπεδο %1</translation>
    </message>
    <message>
        <source>All states</source>
        <translation>Κάθε κατάσταση</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Κατάσταση</translation>
    </message>
    <message>
        <source>All results</source>
        <translation>Κάθε αποτέλεσμα</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Αποτέλεσμα</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Δύναμη</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>Οποτεδήποτε</translation>
    </message>
    <message>
        <source>When it was recorded</source>
        <translation>Πότε καταγράφηκε</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Σήμερα</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Τελευταίες 7 ημέρες</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Τελευταίες 30 ημέρες</translation>
    </message>
    <message>
        <source>Chosen days</source>
        <translation>Επιλεγμένες ημέρες</translation>
    </message>
    <message>
        <source>From this day</source>
        <translation>Από αυτή την ημέρα</translation>
    </message>
    <message>
        <source>To this day</source>
        <translation>Έως αυτή την ημέρα</translation>
    </message>
    <message>
        <source>Has comments</source>
        <translation>Με σχόλια</translation>
    </message>
    <message>
        <source>Reviewed or not</source>
        <translation>Αξιολογημένες ή όχι</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Αξιολόγηση</translation>
    </message>
    <message>
        <source>To review</source>
        <translation>Προς αξιολόγηση</translation>
    </message>
    <message>
        <source>Reviewed</source>
        <translation>Αξιολογήθηκε</translation>
    </message>
    <message>
        <source>Force felt or only shown</source>
        <translation>Δύναμη αισθητή ή μόνο προβολή</translation>
    </message>
    <message>
        <source>Force felt by the hand</source>
        <translation>Δύναμη αισθητή στο χέρι</translation>
    </message>
    <message>
        <source>Force only shown, not felt</source>
        <translation>Μόνο προβολή δύναμης</translation>
    </message>
    <message>
        <source>Whether the device let the hand feel the force, or the screen only showed it, as with mouse and keyboard</source>
        <translation>Αν η συσκευή άφηνε το χέρι να αισθανθεί τη δύναμη ή η οθόνη μόνο την έδειχνε, όπως με ποντίκι και πληκτρολόγιο</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionLines</name>
    <message>
        <source>%1. %2. %3. Opens the debrief.</source>
        <translation>%1. %2. %3. Ανοίγει τον απολογισμό.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionTableModel</name>
    <message>
        <source>%1, archived</source>
        <translation>%1, αρχειοθετημένη</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>Έναρξη</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Άτομο</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Άσκηση</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Επίπεδο</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Αποτέλεσμα</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Δύναμη</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Διάρκεια</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>σφραγισμένο</translation>
    </message>
    <message>
        <source>The length of a session in a blinded study is shown once the study is unblinded.</source>
        <translation>Η διάρκεια μιας συνεδρίας τυφλής μελέτης εμφανίζεται μετά την άρση της τυφλότητας.</translation>
    </message>
    <message>
        <source>Length: %1.</source>
        <translation>Διάρκεια: %1.</translation>
    </message>
    <message>
        <source>Pass marks met: %1.</source>
        <translation>Όρια επιτυχίας που επετεύχθησαν: %1.</translation>
    </message>
    <message>
        <source>Session %1. %2</source>
        <translation>Συνεδρία %1. %2</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Χειριστής</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Βαθμολογία</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Σχόλια</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Αξιολόγηση</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Προσπάθεια</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Αρ.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionsScreen</name>
    <message>
        <source>Search in the list</source>
        <translation>Αναζήτηση στη λίστα</translation>
    </message>
    <message>
        <source>Save the list …</source>
        <translation>Αποθήκευση λίστας …</translation>
    </message>
    <message>
        <source>Bring back from the archive</source>
        <translation>Επιστροφή από το αρχείο</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Αρχειοθέτηση</translation>
    </message>
    <message>
        <source>Session %1 is still running. It can be opened as soon as it has ended.</source>
        <translation>Η συνεδρία %1 είναι ακόμη σε εξέλιξη. Ανοίγει μόλις τελειώσει.</translation>
    </message>
    <message>
        <source>Session %1 was not voided.</source>
        <translation>Η συνεδρία %1 δεν ακυρώθηκε.</translation>
    </message>
    <message>
        <source>Session %1 is voided. Its recording is kept; it no longer counts.</source>
        <translation>Η συνεδρία %1 ακυρώθηκε. Η καταγραφή της διατηρείται· δεν μετράει πλέον.</translation>
    </message>
    <message>
        <source>Session %1 was not changed.</source>
        <translation>Η συνεδρία %1 δεν άλλαξε.</translation>
    </message>
    <message>
        <source>Session %1 is archived: nothing was deleted.</source>
        <translation>Η συνεδρία %1 αρχειοθετήθηκε: τίποτα δεν διαγράφηκε.</translation>
    </message>
    <message>
        <source>Session %1 is back in the list.</source>
        <translation>Η συνεδρία %1 είναι πάλι στη λίστα.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Αναίρεση</translation>
    </message>
    <message>
        <source>The session could not be read again.</source>
        <translation>Δεν ήταν δυνατή η εκ νέου ανάγνωση της συνεδρίας.</translation>
    </message>
    <message>
        <source>Save the list</source>
        <translation>Αποθήκευση λίστας</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Τιμές χωρισμένες με κόμμα (*.csv)</translation>
    </message>
    <message>
        <source>The list is saved in %1.</source>
        <translation>Η λίστα αποθηκεύτηκε στο %1.</translation>
    </message>
    <message>
        <source>The list was not saved.</source>
        <translation>Η λίστα δεν αποθηκεύτηκε.</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Συνεδρίες</translation>
    </message>
    <message>
        <source>Open the debrief</source>
        <translation>Άνοιγμα απολογισμού</translation>
    </message>
    <message>
        <source>Play back</source>
        <translation>Αναπαραγωγή</translation>
    </message>
    <message>
        <source>Void …</source>
        <translation>Ακύρωση συνεδρίας …</translation>
    </message>
    <message>
        <source>Loading the sessions …</source>
        <translation>Φόρτωση συνεδριών …</translation>
    </message>
    <message>
        <source>The sessions could not be loaded.</source>
        <translation>Δεν ήταν δυνατή η φόρτωση των συνεδριών.</translation>
    </message>
    <message>
        <source>Loading the older sessions …</source>
        <translation>Φόρτωση παλαιότερων συνεδριών …</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n συνεδρία</numerusform>
            <numerusform>%n συνεδρίες</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 sessions</source>
        <translation>%1 από %2 συνεδρίες</translation>
    </message>
    <message>
        <source>No session has been recorded yet</source>
        <translation>Δεν έχει καταγραφεί ακόμη συνεδρία</translation>
    </message>
    <message>
        <source>As soon as somebody trains, the session is listed here.</source>
        <translation>Μόλις εκπαιδευτεί κάποιος, η συνεδρία εμφανίζεται εδώ.</translation>
    </message>
    <message>
        <source>No session matches these filters</source>
        <translation>Καμία συνεδρία δεν ταιριάζει στα φίλτρα</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) in all.</source>
        <translation>
            <numerusform>%n συνεδρία συνολικά.</numerusform>
            <numerusform>%n συνεδρίες συνολικά.</numerusform>
        </translation>
    </message>
    <message>
        <source>Clear the filters</source>
        <translation>Καθαρισμός φίλτρων</translation>
    </message>
    <message>
        <source>A session of a blinded study can be opened once the study is unblinded.</source>
        <translation>Μια συνεδρία τυφλής μελέτης ανοίγει μετά την άρση της τυφλότητας.</translation>
    </message>
    <message>
        <source>Session %1 is still void.</source>
        <translation>Η συνεδρία %1 παραμένει ακυρωμένη.</translation>
    </message>
    <message>
        <source>Session %1 counts again. Its history still shows that it was void.</source>
        <translation>Η συνεδρία %1 μετράει ξανά. Η ακύρωσή της παραμένει καταγεγραμμένη.</translation>
    </message>
    <message>
        <source>Results of this person</source>
        <translation>Αποτελέσματα αυτού του ατόμου</translation>
    </message>
    <message>
        <source>Count it again …</source>
        <translation>Να μετράει ξανά …</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) to review</source>
        <translation>
            <numerusform>%n συνεδρία προς αξιολόγηση</numerusform>
            <numerusform>%n συνεδρίες προς αξιολόγηση</numerusform>
        </translation>
    </message>
    <message>
        <source>The list is empty, so there is nothing to save.</source>
        <translation>Η λίστα είναι κενή, οπότε δεν υπάρχει τίποτα να αποθηκευτεί.</translation>
    </message>
    <message>
        <source>All sessions recorded at this site, newest first.

Type in the search field or choose from the lists beside it to narrow the list. What you choose stays for the rest of the day. A link from another screen, such as &quot;List of sessions to review&quot;, shows its own list and leaves your choice as it was. Click a column header to sort by it.

Press Enter or double-click to open the debrief of the selected session, Ctrl+P to play it back. &quot;Results of this person&quot; shows how this person develops at that session&apos;s exercise and level. &quot;Void&quot; asks for a reason and takes a session out of every count; the recording is kept, and &quot;Count it again&quot; takes the decision back. &quot;Archive&quot; takes it out of the usual lists and can be undone.</source>
        <translation>Όλες οι συνεδρίες που καταγράφηκαν σε αυτό το κέντρο, οι νεότερες πρώτα.

Πληκτρολογήστε στο πεδίο αναζήτησης ή επιλέξτε από τις διπλανές λίστες για να περιορίσετε τη λίστα. Ό,τι επιλέγετε παραμένει για την υπόλοιπη ημέρα. Ένας σύνδεσμος από άλλη οθόνη, όπως η «Λίστα συνεδριών προς αξιολόγηση», δείχνει τη δική του λίστα και αφήνει την επιλογή σας όπως ήταν. Κάντε κλικ σε μια επικεφαλίδα στήλης για ταξινόμηση.

Με Enter ή διπλό κλικ ανοίγει ο απολογισμός της επιλεγμένης συνεδρίας, με Ctrl+P η αναπαραγωγή της. Τα «Αποτελέσματα αυτού του ατόμου» δείχνουν την εξέλιξή του στην άσκηση και το επίπεδό της. Η «Ακύρωση συνεδρίας» ζητά αιτιολογία και αφαιρεί μια συνεδρία από κάθε μέτρηση· η καταγραφή διατηρείται, και το «Να μετράει ξανά» αναιρεί την απόφαση. Η «Αρχειοθέτηση» την αφαιρεί από τις συνηθισμένες λίστες και μπορεί να αναιρεθεί.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SettingsScreen</name>
    <message>
        <source>Settings</source>
        <translation>Ρυθμίσεις</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Γλώσσα</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Ανοιχτά</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Σκούρα</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Υψηλή αντίθεση</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Χρώματα</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Size of text and controls</source>
        <translation>Μέγεθος κειμένου και κουμπιών</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ήχος</translation>
    </message>
    <message>
        <source>Play sounds while training</source>
        <translation>Ήχοι κατά την εκπαίδευση</translation>
    </message>
    <message>
        <source>A click when contact begins</source>
        <translation>Ένα κλικ όταν αρχίζει η επαφή</translation>
    </message>
    <message>
        <source>A tone that rises with force</source>
        <translation>Ένας τόνος που ανεβαίνει με τη δύναμη</translation>
    </message>
    <message>
        <source>A warning over the limit</source>
        <translation>Μια προειδοποίηση πάνω από το όριο</translation>
    </message>
    <message>
        <source>Everything that can be heard is also shown. The force behind it is recorded even when the sound is off.</source>
        <translation>Ό,τι ακούγεται φαίνεται και στην οθόνη. Η δύναμη πίσω του καταγράφεται και με τον ήχο κλειστό.</translation>
    </message>
    <message>
        <source>How the program looks and sounds on this station.

Every choice takes effect at once and is remembered on this computer. Nothing here changes what is recorded or how it is scored.

Administrators also give the site its name here.</source>
        <translation>Η εμφάνιση και ο ήχος του προγράμματος σε αυτόν τον σταθμό.

Κάθε επιλογή ισχύει αμέσως και μένει σε αυτόν τον υπολογιστή. Τίποτα εδώ δεν αλλάζει όσα καταγράφονται ή τη βαθμολόγησή τους.

Οι διαχειριστές δίνουν εδώ και το όνομα του κέντρου.</translation>
    </message>
    <message>
        <source>A brighter tone the more the force leans</source>
        <translation>Οξύτερος τόνος σε λοξή δύναμη</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SideBar</name>
    <message>
        <source>Find a command</source>
        <translation>Εύρεση εντολής</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Βοήθεια</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Κλείδωμα</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n session(s) with new comments</source>
        <translation>
            <numerusform>%1: %n συνεδρία με νέα σχόλια</numerusform>
            <numerusform>%1: %n συνεδρίες με νέα σχόλια</numerusform>
        </translation>
    </message>
    <message>
        <source>My account</source>
        <translation>Λογαριασμός</translation>
    </message>
    <message>
        <source>Log out</source>
        <translation>Αποσύνδεση</translation>
    </message>
    <message>
        <source>Back to the login screen, where somebody else can log in</source>
        <translation>Πίσω στην οθόνη σύνδεσης, όπου μπορεί να συνδεθεί κάποιος άλλος</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SidePanel</name>
    <message>
        <source>Ctrl+Page Down: read on</source>
        <translation>Ctrl+Page Down: συνέχεια ανάγνωσης</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SignedBar</name>
    <message>
        <source>%1 %2, over the limit</source>
        <translation>%1 %2, πάνω από το όριο</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>πάνω από το όριο</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SiteBox</name>
    <message>
        <source>Site</source>
        <translation>Κέντρο</translation>
    </message>
    <message>
        <source>Name of the site, such as the clinic&apos;s (may be left empty)</source>
        <translation>Όνομα του κέντρου, π.χ. της κλινικής (προαιρετικό)</translation>
    </message>
    <message>
        <source>Everybody sees it at the login, on password slips and at the top of reports. Each change is recorded in the audit trail.</source>
        <translation>Όλοι το βλέπουν στη σύνδεση, στα σημειώματα κωδικών και στην κορυφή των αναφορών. Κάθε αλλαγή σημειώνεται στο ημερολόγιο ελέγχου.</translation>
    </message>
    <message>
        <source>Save the site&apos;s name</source>
        <translation>Αποθήκευση ονόματος κέντρου</translation>
    </message>
    <message>
        <source>The site&apos;s name could not be read.
%1</source>
        <translation>Το όνομα του κέντρου δεν διαβάστηκε.
%1</translation>
    </message>
    <message>
        <source>The site has no name any more.</source>
        <translation>Το κέντρο δεν έχει πια όνομα.</translation>
    </message>
    <message>
        <source>The site is now called %1.</source>
        <translation>Το κέντρο ονομάζεται τώρα %1.</translation>
    </message>
    <message>
        <source>The site&apos;s name was not changed.
%1</source>
        <translation>Το όνομα του κέντρου δεν άλλαξε.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SizeRow</name>
    <message>
        <source>Size: one millimetre smaller</source>
        <translation>Μέγεθος: ένα χιλιοστό μικρότερο</translation>
    </message>
    <message>
        <source>Size: one millimetre larger</source>
        <translation>Μέγεθος: ένα χιλιοστό μεγαλύτερο</translation>
    </message>
    <message>
        <source>Dashed: the pad of the finger. Keys + and −</source>
        <translation>Διακεκομμένα: η ρώγα του δακτύλου. Πλήκτρα + και −</translation>
    </message>
    <message>
        <source>Size: %1</source>
        <translation>Μέγεθος: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SlipsPanel</name>
    <message>
        <source>These passwords are shown only now. The program keeps no readable copy: print or save the slips before you close this window.</source>
        <translation>Αυτοί οι κωδικοί πρόσβασης εμφανίζονται μόνο τώρα. Το πρόγραμμα δεν κρατά αναγνώσιμο αντίγραφο: τυπώστε ή αποθηκεύστε τα σημειώματα πριν κλείσετε αυτό το παράθυρο.</translation>
    </message>
    <message>
        <source>Name of the site on the slips (may be left empty)</source>
        <translation>Όνομα του κέντρου στα σημειώματα (προαιρετικό)</translation>
    </message>
    <message>
        <source>Print the slips …</source>
        <translation>Εκτύπωση σημειωμάτων …</translation>
    </message>
    <message>
        <source>Save as PDF …</source>
        <translation>Αποθήκευση ως PDF …</translation>
    </message>
    <message>
        <source>New people and their passwords</source>
        <translation>Νέα άτομα και οι κωδικοί πρόσβασής τους</translation>
    </message>
    <message>
        <source>Full name</source>
        <translation>Πλήρες όνομα</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Όνομα χρήστη</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Κωδικός πρόσβασης</translation>
    </message>
    <message>
        <source>Login slips</source>
        <translation>Σημειώματα σύνδεσης</translation>
    </message>
    <message>
        <source>The slips were sent to the printer. Check the paper before you close this window.</source>
        <translation>Τα σημειώματα στάλθηκαν στον εκτυπωτή. Ελέγξτε το χαρτί πριν κλείσετε αυτό το παράθυρο.</translation>
    </message>
    <message>
        <source>The slips could not be printed. Choose another printer, or save them as PDF.</source>
        <translation>Δεν ήταν δυνατή η εκτύπωση των σημειωμάτων. Επιλέξτε άλλον εκτυπωτή ή αποθηκεύστε τα ως PDF.</translation>
    </message>
    <message>
        <source>Save the slips as PDF</source>
        <translation>Αποθήκευση σημειωμάτων ως PDF</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>login-slips</source>
        <translation>simeiomata</translation>
    </message>
    <message>
        <source>The slips were saved to %1, which only you can read. Delete the file once they are printed.</source>
        <translation>Τα σημειώματα αποθηκεύτηκαν στο %1, που μόνο εσείς μπορείτε να διαβάσετε. Διαγράψτε το αρχείο μόλις τυπωθούν.</translation>
    </message>
    <message>
        <source>The slips were not saved.
%1</source>
        <translation>Τα σημειώματα δεν αποθηκεύτηκαν.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SoundSign</name>
    <message>
        <source>Current sound</source>
        <translation>Τρέχων ήχος</translation>
    </message>
    <message>
        <source>Shows what can be heard: start of contact, pitch of the tone, warning</source>
        <translation>Δείχνει τι ακούγεται: έναρξη επαφής, ύψος του τόνου, προειδοποίηση</translation>
    </message>
    <message>
        <source>Warning: pressed too hard</source>
        <translation>Προειδοποίηση: πολύ δυνατή πίεση</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Επαφή</translation>
    </message>
    <message>
        <source>No tone</source>
        <translation>Χωρίς τόνο</translation>
    </message>
    <message>
        <source>Low tone</source>
        <translation>Χαμηλός τόνος</translation>
    </message>
    <message>
        <source>Medium tone</source>
        <translation>Μεσαίος τόνος</translation>
    </message>
    <message>
        <source>High tone</source>
        <translation>Υψηλός τόνος</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StatePanel</name>
    <message>
        <source>Progress</source>
        <translation>Πρόοδος</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Άκυρο</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Νέα προσπάθεια</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StationScreen</name>
    <message>
        <source>Station</source>
        <translation>Σταθμός</translation>
    </message>
    <message>
        <source>Checking the station …</source>
        <translation>Έλεγχος του σταθμού …</translation>
    </message>
    <message>
        <source>The station could not be checked.</source>
        <translation>Δεν ήταν δυνατός ο έλεγχος του σταθμού.</translation>
    </message>
    <message>
        <source>Timing of the force loop</source>
        <translation>Χρονισμός του βρόχου δύναμης</translation>
    </message>
    <message>
        <source>Session %1, %2</source>
        <translation>Συνεδρία %1, %2</translation>
    </message>
    <message>
        <source>None of the latest sessions ran in real time, so it is not yet known how well this station keeps time.</source>
        <translation>Καμία από τις τελευταίες συνεδρίες δεν έτρεξε σε πραγματικό χρόνο, οπότε δεν είναι ακόμη γνωστό πόσο καλά τηρεί τον χρόνο αυτός ο σταθμός.</translation>
    </message>
    <message>
        <source>Self-test without a device</source>
        <translation>Αυτοέλεγχος χωρίς συσκευή</translation>
    </message>
    <message>
        <source>Run the self-test</source>
        <translation>Εκτέλεση αυτοελέγχου</translation>
    </message>
    <message>
        <source>This session was recorded before the program stored how delays are distributed.</source>
        <translation>Όταν καταγράφηκε αυτή η συνεδρία, το πρόγραμμα δεν αποθήκευε ακόμη την κατανομή των καθυστερήσεων.</translation>
    </message>
    <message>
        <source>The system said: %1</source>
        <translation>Το σύστημα ανέφερε: %1</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Συσκευές</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>Ελεύθερος χώρος</translation>
    </message>
    <message>
        <source>A running session keeps its last seconds in memory, so that a crash loses nothing. It needs %1 of the %2 that are free there.</source>
        <translation>Μια συνεδρία σε εξέλιξη κρατά τα τελευταία δευτερόλεπτα στη μνήμη, ώστε να μη χαθεί τίποτα αν κλείσει απότομα το πρόγραμμα. Χρειάζεται %1 από τα %2 που είναι ελεύθερα εκεί.</translation>
    </message>
    <message>
        <source>Testing the loop. Do not use the computer meanwhile.</source>
        <translation>Έλεγχος του βρόχου. Μη χρησιμοποιείτε στο μεταξύ τον υπολογιστή.</translation>
    </message>
    <message>
        <source>The self-test was stopped before it finished.</source>
        <translation>Ο αυτοέλεγχος σταμάτησε πριν τελειώσει.</translation>
    </message>
    <message>
        <source>Verifying the fingertip platform.</source>
        <translation>Έλεγχος της πλατφόρμας δακτύλου.</translation>
    </message>
    <message>
        <source>Save the record</source>
        <translation>Αποθήκευση του πρακτικού</translation>
    </message>
    <message>
        <source>Fingertip platform.pdf</source>
        <translation>Πλατφόρμα δακτύλου.pdf</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>Έγγραφα PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The record was saved in %1.</source>
        <translation>Το πρακτικό αποθηκεύτηκε στο %1.</translation>
    </message>
    <message>
        <source>The record could not be saved.</source>
        <translation>Δεν ήταν δυνατή η αποθήκευση του πρακτικού.</translation>
    </message>
    <message>
        <source>Verify the fingertip platform</source>
        <translation>Έλεγχος της πλατφόρμας δακτύλου</translation>
    </message>
    <message>
        <source>The check could not be written to the audit trail.</source>
        <translation>Ο έλεγχος δεν ήταν δυνατό να γραφτεί στο ημερολόγιο ελέγχου.</translation>
    </message>
    <message>
        <source>Simulated fingertip platform</source>
        <translation>Προσομοιωμένη πλατφόρμα δακτύλου</translation>
    </message>
    <message>
        <source>None: the loop alone, without a device</source>
        <translation>Καμία: μόνο ο βρόχος, χωρίς συσκευή</translation>
    </message>
    <message>
        <source>Shows whether this computer is fast and regular enough for haptic force.

Force is computed a thousand times per second. The charts show how late those thousand steps began: in the last session that ran in real time, and in a self-test of ten seconds without any device.

The fingertip platform is verified as in its publication: how closely it follows a force and an orientation. Each check is kept in the audit trail, and its record can be saved and filed: who, when, on which device and build, and each measured value beside its limit.

With real-time priority the loop stays on time whatever else the computer does. This screen shows whether the loop has that priority and how to permit it.</source>
        <translation>Δείχνει αν αυτός ο υπολογιστής είναι αρκετά γρήγορος και σταθερός για απτική δύναμη.

Η δύναμη υπολογίζεται χίλιες φορές το δευτερόλεπτο. Τα διαγράμματα δείχνουν με πόση καθυστέρηση ξεκίνησαν αυτά τα χίλια βήματα: στην τελευταία συνεδρία που εκτελέστηκε σε πραγματικό χρόνο και σε έναν αυτοέλεγχο δέκα δευτερολέπτων χωρίς συσκευή.

Η πλατφόρμα δακτύλου ελέγχεται όπως στη δημοσίευσή της: πόσο πιστά ακολουθεί μια δύναμη και έναν προσανατολισμό. Κάθε έλεγχος διατηρείται στο ημερολόγιο ελέγχου και το πρακτικό του μπορεί να αποθηκευτεί και να αρχειοθετηθεί: ποιος, πότε, σε ποια συσκευή και έκδοση, και κάθε μετρημένη τιμή δίπλα στο όριό της.

Με προτεραιότητα πραγματικού χρόνου ο βρόχος τηρεί τον χρόνο ό,τι κι αν κάνει ο υπολογιστής. Αυτή η οθόνη δείχνει αν ο βρόχος έχει αυτή την προτεραιότητα και πώς επιτρέπεται.</translation>
    </message>
    <message>
        <source>Record (PDF) …</source>
        <translation>Αρχείο (PDF) …</translation>
    </message>
    <message>
        <source>Record of the self-test (PDF)</source>
        <translation>Πρακτικό του αυτοελέγχου (PDF)</translation>
    </message>
    <message>
        <source>Station check.pdf</source>
        <translation>Έλεγχος σταθμού.pdf</translation>
    </message>
    <message>
        <source>A researcher or an administrator can run it here.</source>
        <translation>Ένας ερευνητής ή διαχειριστής μπορεί να τον εκτελέσει εδώ.</translation>
    </message>
    <message>
        <source>No maker&apos;s haptic device was connected to this version yet: the driver for devices connected by USB, network or serial line was tested against an emulation.</source>
        <translation>Σε αυτή την έκδοση δεν έχει συνδεθεί ακόμη απτική συσκευή κατασκευαστή: το πρόγραμμα οδήγησης για συσκευές μέσω USB, δικτύου ή σειριακής γραμμής δοκιμάστηκε με εξομοίωση.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StorageScreen</name>
    <message>
        <source>Storage</source>
        <translation>Φύλαξη δεδομένων</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>Ελεύθερος χώρος</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>Βάση δεδομένων</translation>
    </message>
    <message>
        <source>Recordings in it</source>
        <translation>Καταγραφές σε αυτήν</translation>
    </message>
    <message>
        <source>Free on this disk</source>
        <translation>Ελεύθερα στον δίσκο</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Αντίγραφα ασφαλείας</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Δημιουργία</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Παλαιότητα</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Μέγεθος</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Έλεγχος</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Φάκελος</translation>
    </message>
    <message>
        <source>Back up now</source>
        <translation>Αντίγραφο τώρα</translation>
    </message>
    <message>
        <source>Check the selected backup</source>
        <translation>Έλεγχος αντιγράφου</translation>
    </message>
    <message>
        <source>Restore the selected backup …</source>
        <translation>Επαναφορά αντιγράφου …</translation>
    </message>
    <message>
        <source>Choose the folder …</source>
        <translation>Επιλογή φακέλου …</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Έλεγχος ακεραιότητας</translation>
    </message>
    <message>
        <source>Reads every record, recomputes every score from its recording and checks the audit trail. It changes nothing.</source>
        <translation>Διαβάζει κάθε εγγραφή, υπολογίζει ξανά κάθε βαθμολογία από την καταγραφή της και ελέγχει το ημερολόγιο ελέγχου. Δεν αλλάζει τίποτα.</translation>
    </message>
    <message>
        <source>Problems found</source>
        <translation>Προβλήματα που βρέθηκαν</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Τι</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Πού</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Λεπτομέρειες</translation>
    </message>
    <message>
        <source>Verify everything</source>
        <translation>Έλεγχος όλων</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Εξαγωγή</translation>
    </message>
    <message>
        <source>A backup and every table as text (JSON Lines, without passwords), for analysis elsewhere or to move all data to another program.</source>
        <translation>Αντίγραφο ασφαλείας και κάθε πίνακας ως κείμενο (JSON Lines, χωρίς κωδικούς πρόσβασης), για ανάλυση αλλού ή για μεταφορά όλων των δεδομένων σε άλλο πρόγραμμα.</translation>
    </message>
    <message>
        <source>Export the site …</source>
        <translation>Εξαγωγή του κέντρου …</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 σε %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 from %n session(s)</source>
        <translation>
            <numerusform>%1 από %n συνεδρία</numerusform>
            <numerusform>%1 από %n συνεδρίες</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 από %2</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Φυλάσσονται στο %1</translation>
    </message>
    <message>
        <source>When created</source>
        <translation>Κατά τη δημιουργία</translation>
    </message>
    <message>
        <source>Just now: intact</source>
        <translation>Μόλις τώρα: ακέραιο</translation>
    </message>
    <message>
        <source>Just now: damaged</source>
        <translation>Μόλις τώρα: με βλάβη</translation>
    </message>
    <message>
        <source>Wait until the restore has finished.</source>
        <translation>Περιμένετε να τελειώσει η επαναφορά.</translation>
    </message>
    <message>
        <source>The task that you started continues in the background.</source>
        <translation>Η εργασία που ξεκινήσατε συνεχίζεται στο παρασκήνιο.</translation>
    </message>
    <message>
        <source>Checking the storage …</source>
        <translation>Έλεγχος της φύλαξης δεδομένων …</translation>
    </message>
    <message>
        <source>The storage could not be checked.</source>
        <translation>Δεν ήταν δυνατός ο έλεγχος της φύλαξης δεδομένων.</translation>
    </message>
    <message>
        <source>Folder for the export</source>
        <translation>Φάκελος εξαγωγής</translation>
    </message>
    <message>
        <source>Folder for backups</source>
        <translation>Φάκελος αντιγράφων ασφαλείας</translation>
    </message>
    <message>
        <source>The backup is made and checked: %1 in %2.</source>
        <translation>Το αντίγραφο ασφαλείας δημιουργήθηκε και ελέγχθηκε: %1 στο %2.</translation>
    </message>
    <message>
        <source>The site is exported and checked: %1 in %2.</source>
        <translation>Η εξαγωγή του κέντρου έγινε και ελέγχθηκε: %1 στο %2.</translation>
    </message>
    <message>
        <source>The backup was stopped; nothing was saved.</source>
        <translation>Η δημιουργία αντιγράφου σταμάτησε· δεν αποθηκεύτηκε τίποτα.</translation>
    </message>
    <message>
        <source>The export was stopped; nothing was saved.</source>
        <translation>Η εξαγωγή σταμάτησε· δεν αποθηκεύτηκε τίποτα.</translation>
    </message>
    <message>
        <source>The backup was not made.</source>
        <translation>Το αντίγραφο ασφαλείας δεν δημιουργήθηκε.</translation>
    </message>
    <message>
        <source>The site was not exported.</source>
        <translation>Δεν έγινε εξαγωγή του κέντρου.</translation>
    </message>
    <message>
        <source>Making a backup …</source>
        <translation>Δημιουργία αντιγράφου ασφαλείας …</translation>
    </message>
    <message>
        <source>Exporting the site …</source>
        <translation>Εξαγωγή του κέντρου …</translation>
    </message>
    <message>
        <source>Verifying everything …</source>
        <translation>Έλεγχος όλων …</translation>
    </message>
    <message>
        <source>Checking the backup …</source>
        <translation>Έλεγχος του αντιγράφου …</translation>
    </message>
    <message>
        <source>Restoring the backup. The current database is kept.</source>
        <translation>Επαναφορά του αντιγράφου. Η τωρινή βάση δεδομένων φυλάσσεται.</translation>
    </message>
    <message>
        <source>Nothing was restored. The current database is unchanged.</source>
        <translation>Δεν έγινε επαναφορά. Η τωρινή βάση δεδομένων δεν άλλαξε.</translation>
    </message>
    <message>
        <source>The current database could not be opened again.</source>
        <translation>Δεν ήταν δυνατό να ανοίξει ξανά η τωρινή βάση δεδομένων.</translation>
    </message>
    <message>
        <source>The backup was restored. The previous database is kept as %1. Please log in again.</source>
        <translation>Έγινε επαναφορά του αντιγράφου. Η προηγούμενη βάση δεδομένων φυλάσσεται ως %1. Παρακαλούμε συνδεθείτε ξανά.</translation>
    </message>
    <message>
        <source>Shows where all recorded data is kept and whether it is safe.

&quot;Back up now&quot; makes a copy while the program is running and checks it before it counts. Keep backups on another disk: choose the folder here.

&quot;Automatic backups&quot; makes one per day and keeps as many as you say; backups that you made yourself are never removed.

&quot;Verify&quot; reads everything again: each record, each recording, each score, the audit trail. It changes nothing and can be stopped.

&quot;Restore&quot; goes back to a backup. It asks an administrator for the password, keeps a copy of the current database, and logs everybody out.</source>
        <translation>Δείχνει πού φυλάσσονται όλα τα δεδομένα που καταγράφηκαν και αν είναι ασφαλή.

Το «Αντίγραφο τώρα» δημιουργεί αντίγραφο ενώ το πρόγραμμα λειτουργεί και το ελέγχει πριν θεωρηθεί έγκυρο. Φυλάξτε τα αντίγραφα ασφαλείας σε άλλον δίσκο: επιλέξτε τον φάκελο εδώ.

Τα «Αυτόματα αντίγραφα ασφαλείας» δημιουργούν ένα την ημέρα και διατηρούν όσα ορίσετε· όσα δημιουργήσατε εσείς δεν αφαιρούνται ποτέ.

Ο «Έλεγχος ακεραιότητας» ξαναδιαβάζει τα πάντα: κάθε εγγραφή, κάθε καταγραφή, κάθε βαθμολογία, το ημερολόγιο ελέγχου. Δεν αλλάζει τίποτα και μπορεί να σταματήσει.

Η «Επαναφορά» επιστρέφει σε ένα αντίγραφο ασφαλείας. Ζητά τον κωδικό πρόσβασης ενός διαχειριστή, φυλάσσει την τωρινή βάση δεδομένων και αποσυνδέει όλους.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Είδος</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Αυτόματο</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Χειροκίνητο</translation>
    </message>
    <message>
        <source>The plan for automatic backups was not saved.</source>
        <translation>Το πρόγραμμα των αυτόματων αντιγράφων ασφαλείας δεν αποθηκεύτηκε.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StudiesScreen</name>
    <message>
        <source>Import a study</source>
        <translation>Εισαγωγή μελέτης</translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation>Μελέτες (*.json)</translation>
    </message>
    <message>
        <source>The file could not be read.</source>
        <translation>Το αρχείο δεν διαβάστηκε.</translation>
    </message>
    <message>
        <source>The study was not imported.</source>
        <translation>Η μελέτη δεν εισήχθη.</translation>
    </message>
    <message>
        <source>The study was not created.</source>
        <translation>Η μελέτη δεν δημιουργήθηκε.</translation>
    </message>
    <message>
        <source>%1 was created as a draft.</source>
        <translation>Η μελέτη %1 δημιουργήθηκε ως πρόχειρο.</translation>
    </message>
    <message>
        <source>%1 was not changed.</source>
        <translation>Η μελέτη %1 δεν άλλαξε.</translation>
    </message>
    <message>
        <source>%1 is archived: nothing was deleted.</source>
        <translation>Η μελέτη %1 αρχειοθετήθηκε: τίποτα δεν διαγράφηκε.</translation>
    </message>
    <message>
        <source>%1 is back in the list.</source>
        <translation>Η μελέτη %1 είναι πάλι στη λίστα.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Αναίρεση</translation>
    </message>
    <message>
        <source>Close %1?</source>
        <translation>Κλείσιμο: %1;</translation>
    </message>
    <message>
        <source>No more participants can be enrolled and no more runs started; open runs can still be finished. This cannot be undone.</source>
        <translation>Δεν εγγράφονται άλλοι συμμετέχοντες και δεν αρχίζουν άλλες εκτελέσεις· οι ανοικτές μπορούν να τελειώσουν. Δεν αναιρείται.</translation>
    </message>
    <message>
        <source>Keep it open</source>
        <translation>Να μείνει ανοικτή</translation>
    </message>
    <message>
        <source>Close the study</source>
        <translation>Κλείσιμο μελέτης</translation>
    </message>
    <message>
        <source>The study was not closed.</source>
        <translation>Η μελέτη δεν έκλεισε.</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Μελέτες</translation>
    </message>
    <message>
        <source>New study …</source>
        <translation>Νέα μελέτη …</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Εισαγωγή …</translation>
    </message>
    <message>
        <source>Show archived</source>
        <translation>Και αρχειοθετημένες</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Μελέτη</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Κατάσταση</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Συμμετέχοντες</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Δοκιμές</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Από</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Άνοιγμα</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Διεξαγωγή</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Δεδομένα</translation>
    </message>
    <message>
        <source>Close …</source>
        <translation>Κλείσιμο …</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Αρχειοθέτηση</translation>
    </message>
    <message>
        <source>Reading the studies …</source>
        <translation>Ανάγνωση των μελετών …</translation>
    </message>
    <message>
        <source>The studies could not be read</source>
        <translation>Οι μελέτες δεν διαβάστηκαν</translation>
    </message>
    <message numerus="yes">
        <source>%n stud(y/ies)</source>
        <translation>
            <numerusform>%n μελέτη</numerusform>
            <numerusform>%n μελέτες</numerusform>
        </translation>
    </message>
    <message>
        <source>No studies yet</source>
        <translation>Δεν υπάρχουν μελέτες</translation>
    </message>
    <message>
        <source>Start from a template and change it: a ranking of three, a staircase or constant stimuli.</source>
        <translation>Ξεκινήστε από ένα πρότυπο και προσαρμόστε το: κατάταξη τριών, κλιμακωτή μέθοδο ή σταθερά ερεθίσματα.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>καμία</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>ολοκλήρωσαν %1 από %2</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Επαναφορά</translation>
    </message>
    <message>
        <source>Open the study</source>
        <translation>Άνοιγμα μελέτης</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Κλειδί</translation>
    </message>
    <message>
        <source>Choose a study in the list first.</source>
        <translation>Επιλέξτε πρώτα μια μελέτη από τη λίστα.</translation>
    </message>
    <message>
        <source>The design is still a draft: freeze it first.</source>
        <translation>Το σχέδιο είναι ακόμη πρόχειρο: οριστικοποιήστε το πρώτα.</translation>
    </message>
    <message>
        <source>The study is archived: bring it back first.</source>
        <translation>Η μελέτη είναι αρχειοθετημένη: επαναφέρετέ την πρώτα.</translation>
    </message>
    <message>
        <source>The study is closed already.</source>
        <translation>Η μελέτη έχει ήδη κλείσει.</translation>
    </message>
    <message>
        <source>The study could not be read.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση της μελέτης.</translation>
    </message>
    <message>
        <source>The study is blind. Only its author and administrators can copy it before it is unblinded.</source>
        <translation>Η μελέτη είναι τυφλή. Πριν από την άρση της τυφλότητας μπορούν να την αντιγράψουν μόνο ο δημιουργός της και οι διαχειριστές.</translation>
    </message>
    <message>
        <source>Copy to new study …</source>
        <translation>Αντιγραφή σε νέα μελέτη …</translation>
    </message>
    <message>
        <source>All studies of this site. A draft is designed and tried out with simulated observers. Once it is frozen, its design can never be changed again: every export states its SHA-256, and participants are enrolled under random codes.

&quot;New study&quot; starts from a template or from scratch; &quot;Import&quot; reads a study from a JSON file. Press Enter or double-click to open a study. &quot;Run&quot; takes a participant through it, &quot;Data&quot; shows the results.

&quot;Close&quot; ends enrolment for good. &quot;Archive&quot; takes a study out of the list and can be undone.</source>
        <translation>Όλες οι μελέτες αυτού του κέντρου. Ένα πρόχειρο σχεδιάζεται και δοκιμάζεται με προσομοιωμένους παρατηρητές. Μόλις οριστικοποιηθεί, το σχέδιο δεν αλλάζει ποτέ: το SHA-256 του βρίσκεται σε κάθε εξαγωγή, και οι συμμετέχοντες εγγράφονται με τυχαίους κωδικούς.

Η «Νέα μελέτη» αρχίζει από πρότυπο ή από το μηδέν· η «Εισαγωγή» διαβάζει μελέτη από αρχείο JSON. Το Enter ή το διπλό κλικ ανοίγει μια μελέτη. Η «Διεξαγωγή» οδηγεί έναν συμμετέχοντα στη μελέτη, τα «Δεδομένα» δείχνουν τα αποτελέσματα.

Το «Κλείσιμο» τερματίζει οριστικά την εγγραφή. Η «Αρχειοθέτηση» βγάζει μια μελέτη από τη λίστα και αναιρείται.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StudyDataScreen</name>
    <message>
        <source>CSV …</source>
        <translation>CSV …</translation>
    </message>
    <message>
        <source>BIDS …</source>
        <translation>BIDS …</translation>
    </message>
    <message>
        <source>PDF …</source>
        <translation>PDF …</translation>
    </message>
    <message>
        <source>Unblind …</source>
        <translation>Άρση τυφλότητας …</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Εξαγωγή σε CSV</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>Αποθήκευση ως PDF</translation>
    </message>
    <message>
        <source>Export as BIDS</source>
        <translation>Εξαγωγή σε BIDS</translation>
    </message>
    <message>
        <source>Choose a location for the folder</source>
        <translation>Επιλογή θέσης για τον φάκελο</translation>
    </message>
    <message>
        <source>Writing the tables …</source>
        <translation>Εγγραφή των πινάκων …</translation>
    </message>
    <message>
        <source>The tables were written to %1.</source>
        <translation>Οι πίνακες γράφτηκαν στο %1.</translation>
    </message>
    <message>
        <source>The tables could not be written.</source>
        <translation>Οι πίνακες δεν γράφτηκαν.</translation>
    </message>
    <message>
        <source>Writing the BIDS dataset …</source>
        <translation>Εγγραφή του συνόλου δεδομένων BIDS …</translation>
    </message>
    <message>
        <source>The BIDS dataset was written to %1.</source>
        <translation>Το σύνολο δεδομένων BIDS γράφτηκε στο %1.</translation>
    </message>
    <message>
        <source>The BIDS dataset could not be written.</source>
        <translation>Το σύνολο δεδομένων BIDS δεν γράφτηκε.</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The report was written to %1.</source>
        <translation>Η αναφορά γράφτηκε στο %1.</translation>
    </message>
    <message>
        <source>The report could not be written.</source>
        <translation>Δεν ήταν δυνατή η εγγραφή της αναφοράς.</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Δεδομένα</translation>
    </message>
    <message>
        <source>Reading the studies …</source>
        <translation>Ανάγνωση των μελετών …</translation>
    </message>
    <message>
        <source>The studies could not be read</source>
        <translation>Οι μελέτες δεν διαβάστηκαν</translation>
    </message>
    <message>
        <source>No data yet</source>
        <translation>Δεν υπάρχουν δεδομένα</translation>
    </message>
    <message>
        <source>Data appear here once participants have taken part in a frozen study.</source>
        <translation>Τα δεδομένα εμφανίζονται εδώ αφού συμμετάσχουν άτομα σε οριστικοποιημένη μελέτη.</translation>
    </message>
    <message>
        <source>Open the studies</source>
        <translation>Άνοιγμα μελετών</translation>
    </message>
    <message>
        <source>Analysing the runs …</source>
        <translation>Ανάλυση των εκτελέσεων …</translation>
    </message>
    <message>
        <source>The study could not be analysed</source>
        <translation>Η μελέτη δεν αναλύθηκε</translation>
    </message>
    <message>
        <source>Views of the data</source>
        <translation>Προβολές των δεδομένων</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Ομάδα</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Άτομο</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Δοκιμές</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Ερωτήσεις</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Μελέτη</translation>
    </message>
    <message>
        <source>SHA-256 %1</source>
        <translation>SHA-256 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>%n συμμετέχων</numerusform>
            <numerusform>%n συμμετέχοντες</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n scored trial(s)</source>
        <translation>
            <numerusform>%n βαθμολογημένη δοκιμή</numerusform>
            <numerusform>%n βαθμολογημένες δοκιμές</numerusform>
        </translation>
    </message>
    <message>
        <source>unblinded</source>
        <translation>χωρίς τυφλότητα</translation>
    </message>
    <message>
        <source>blind: conditions shown by sealed codes</source>
        <translation>τυφλή: συνθήκες με σφραγισμένους κωδικούς</translation>
    </message>
    <message>
        <source>Groups include runs with force shown, not felt</source>
        <translation>Και εκτελέσεις με δύναμη μόνο σε προβολή</translation>
    </message>
    <message>
        <source>The results of a study.

&quot;Group&quot; shows each participant&apos;s Weber fraction with its interval for every condition, and any warnings. &quot;Person&quot; shows the curve of a run with its data. &quot;Trials&quot; lists every presentation with its fidelity and says why one did not count. &quot;Questions&quot; summarises the questionnaires. &quot;Comparison&quot; sets the conditions beside each other, and says who or what is missing where they cannot be compared.

You can export tables (CSV), a BIDS dataset or a PDF; each contains the design&apos;s SHA-256. While the experimenter is blind, conditions are shown by sealed codes, and of their runs you see only how well each participant&apos;s trials went. Unblinding asks for a reason, is recorded and cannot be undone.</source>
        <translation>Τα αποτελέσματα μιας μελέτης.

Η «Ομάδα» δείχνει το κλάσμα Weber κάθε συμμετέχοντα με το διάστημά του για κάθε συνθήκη, και τυχόν προειδοποιήσεις. Το «Άτομο» δείχνει την καμπύλη μίας εκτέλεσης με τα δεδομένα της. Οι «Δοκιμές» αναγράφουν κάθε παρουσίαση με την πιστότητά της και εξηγούν γιατί κάποια δεν μέτρησε. Οι «Ερωτήσεις» συνοψίζουν τα ερωτηματολόγια. Η «Σύγκριση» βάζει τις συνθήκες δίπλα δίπλα και λέει ποιος ή τι λείπει όπου δεν μπορούν να συγκριθούν.

Μπορείτε να εξαγάγετε πίνακες (CSV), σύνολο BIDS ή PDF· όλα περιέχουν το SHA-256 του σχεδίου. Όσο ο πειραματιστής είναι τυφλός, οι συνθήκες φαίνονται με σφραγισμένους κωδικούς και από τις εκτελέσεις τους βλέπετε μόνο πόσο καλά πήγαν οι δοκιμές κάθε συμμετέχοντα. Η άρση της τυφλότητας απαιτεί αιτιολογία, καταγράφεται και δεν αναιρείται.</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Σύγκριση</translation>
    </message>
    <message>
        <source>The study is not on the screen yet, so nothing was exported. Try again once it is there.</source>
        <translation>Η μελέτη δεν εμφανίζεται ακόμη στην οθόνη, γι’ αυτό δεν εξήχθη τίποτα. Δοκιμάστε ξανά μόλις εμφανιστεί.</translation>
    </message>
    <message>
        <source>Nothing was exported: no place was chosen.</source>
        <translation>Δεν εξήχθη τίποτα: δεν επιλέχθηκε θέση.</translation>
    </message>
    <message>
        <source>There are no scored trials yet.</source>
        <translation>Δεν υπάρχουν ακόμη βαθμολογημένες δοκιμές.</translation>
    </message>
    <message>
        <source>It is an earlier export. You can replace it with the data as they are now, or keep it and write the new export beside it.</source>
        <translation>Είναι προηγούμενη εξαγωγή. Μπορείτε να την αντικαταστήσετε με τα δεδομένα όπως είναι τώρα ή να την κρατήσετε και να γράψετε τη νέα εξαγωγή δίπλα της.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Άκυρο</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Αντικατάσταση</translation>
    </message>
    <message>
        <source>Write beside it</source>
        <translation>Εγγραφή δίπλα</translation>
    </message>
    <message>
        <source>Nothing was exported. %1 is as it was.</source>
        <translation>Δεν εξήχθη τίποτα. Το %1 έμεινε όπως ήταν.</translation>
    </message>
    <message>
        <source>It applies to every page here and to the PDF, and is remembered.</source>
        <translation>Ισχύει για κάθε σελίδα εδώ και για το PDF, και απομνημονεύεται.</translation>
    </message>
    <message>
        <source>The previous export is still being written. Try again once the message says where it was written.</source>
        <translation>Η προηγούμενη εξαγωγή γράφεται ακόμη. Δοκιμάστε ξανά μόλις το μήνυμα αναφέρει πού γράφτηκε.</translation>
    </message>
    <message>
        <source>%1 already exists.</source>
        <translation>Το %1 υπάρχει ήδη.</translation>
    </message>
    <message>
        <source>It is not an export of a study, so it is not replaced. You can write the export beside it.</source>
        <translation>Δεν είναι εξαγωγή μελέτης, γι&apos; αυτό δεν αντικαθίσταται. Μπορείτε να γράψετε την εξαγωγή δίπλα.</translation>
    </message>
    <message>
        <source>In no run of this study was force only shown, so this changes nothing here. The choice is remembered.</source>
        <translation>Σε καμία εκτέλεση αυτής της μελέτης η δύναμη δεν προβλήθηκε μόνο, άρα εδώ δεν αλλάζει τίποτα. Η επιλογή απομνημονεύεται.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StudyScreen</name>
    <message>
        <source>Study</source>
        <translation>Μελέτη</translation>
    </message>
    <message>
        <source>Reading the study …</source>
        <translation>Ανάγνωση της μελέτης …</translation>
    </message>
    <message>
        <source>The study could not be read</source>
        <translation>Η μελέτη δεν διαβάστηκε</translation>
    </message>
    <message>
        <source>Parts of the study</source>
        <translation>Μέρη της μελέτης</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Συνθήκες</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Δοκιμές</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Ερωτήσεις</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Συμμετέχοντες</translation>
    </message>
    <message>
        <source>Freeze …</source>
        <translation>Οριστικοποίηση …</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Αναίρεση</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Επανάληψη</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Εισαγωγή …</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Διεξαγωγή</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Δεδομένα</translation>
    </message>
    <message>
        <source>Save as JSON …</source>
        <translation>Αποθήκευση JSON …</translation>
    </message>
    <message>
        <source>Language of the texts</source>
        <translation>Γλώσσα των κειμένων</translation>
    </message>
    <message>
        <source>The draft could not be saved.
%1</source>
        <translation>Το πρόχειρο δεν αποθηκεύτηκε.
%1</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>κλειδί %1</translation>
    </message>
    <message>
        <source>SHA-256 %1</source>
        <translation>SHA-256 %1</translation>
    </message>
    <message>
        <source>frozen %1</source>
        <translation>οριστικοποιήθηκε %1</translation>
    </message>
    <message>
        <source>unblinded</source>
        <translation>χωρίς τυφλότητα</translation>
    </message>
    <message>
        <source>blind</source>
        <translation>τυφλή</translation>
    </message>
    <message>
        <source>all changes saved</source>
        <translation>όλα αποθηκεύτηκαν</translation>
    </message>
    <message>
        <source>saving …</source>
        <translation>αποθήκευση …</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>δεν αποθηκεύτηκε</translation>
    </message>
    <message>
        <source>The draft could not be saved.</source>
        <translation>Το πρόχειρο δεν αποθηκεύτηκε.</translation>
    </message>
    <message>
        <source>Leave without the last changes?</source>
        <translation>Έξοδος χωρίς τις τελευταίες αλλαγές;</translation>
    </message>
    <message>
        <source>The design still has errors, so the last changes were not saved. The last version without errors is saved.</source>
        <translation>Το σχέδιο έχει ακόμη σφάλματα, γι’ αυτό οι τελευταίες αλλαγές δεν αποθηκεύτηκαν. Η τελευταία μορφή χωρίς σφάλματα έχει αποθηκευτεί.</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Παραμονή</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Έξοδος</translation>
    </message>
    <message>
        <source>Import a design from a file</source>
        <translation>Εισαγωγή σχεδίου από αρχείο</translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation>Μελέτες (*.json)</translation>
    </message>
    <message>
        <source>The file was not imported:
%1</source>
        <translation>Η εισαγωγή του αρχείου δεν έγινε:
%1</translation>
    </message>
    <message>
        <source>Import of a file</source>
        <translation>Εισαγωγή αρχείου</translation>
    </message>
    <message>
        <source>Save the design</source>
        <translation>Αποθήκευση σχεδίου</translation>
    </message>
    <message>
        <source>The design was not saved.</source>
        <translation>Το σχέδιο δεν αποθηκεύτηκε.</translation>
    </message>
    <message>
        <source>The design was saved in %1.</source>
        <translation>Το σχέδιο αποθηκεύτηκε στο %1.</translation>
    </message>
    <message>
        <source>The design must be free of errors before it can be frozen.</source>
        <translation>Το σχέδιο πρέπει να μην έχει σφάλματα για να οριστικοποιηθεί.</translation>
    </message>
    <message>
        <source>The last changes are still being saved.</source>
        <translation>Οι τελευταίες αλλαγές αποθηκεύονται ακόμη.</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Σκοπός</translation>
    </message>
    <message>
        <source>Check and freeze</source>
        <translation>Έλεγχος και οριστικοποίηση</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Show the first</source>
        <translation>Εμφάνιση της πρώτης</translation>
    </message>
    <message>
        <source>Copy to new study …</source>
        <translation>Αντιγραφή σε νέα μελέτη …</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Πίσω</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Επόμενο</translation>
    </message>
    <message>
        <source>Something here must be corrected.</source>
        <translation>Κάτι εδώ πρέπει να διορθωθεί.</translation>
    </message>
    <message numerus="yes">
        <source>Not saved yet: %n entr(y/ies) must be corrected first. %1</source>
        <translation>
            <numerusform>Δεν αποθηκεύτηκε ακόμη: πρώτα πρέπει να διορθωθεί %n καταχώριση. %1</numerusform>
            <numerusform>Δεν αποθηκεύτηκε ακόμη: πρώτα πρέπει να διορθωθούν %n καταχωρίσεις. %1</numerusform>
        </translation>
    </message>
    <message>
        <source>The last changes are still being saved. Try again in a moment.</source>
        <translation>Οι τελευταίες αλλαγές αποθηκεύονται ακόμη. Δοκιμάστε ξανά σε λίγο.</translation>
    </message>
    <message>
        <source>One study. While it is a draft, you can change everything. Go through the pages with &quot;Next&quot; and &quot;Back&quot;, or jump to one by its name. Complete entries are saved at once, Ctrl+Z undoes a step, and a message under a field says what is wrong with it. Beside the pages you see what a participant will see.

&quot;Conditions&quot; defines what is compared, with which task and procedure. &quot;Expected precision&quot; runs the study with simulated observers and shows the expected precision, number of trials and time. &quot;Check and freeze&quot; says what is missing, lets somebody try the design as a pilot, and freezes it permanently under its SHA-256; participants can be enrolled from then on, under random codes, with their consent.</source>
        <translation>Μία μελέτη. Όσο είναι πρόχειρη, μπορείτε να αλλάξετε τα πάντα. Προχωρήστε στις σελίδες με «Επόμενο» και «Πίσω» ή μεταβείτε σε μία από το όνομά της. Οι πλήρεις καταχωρίσεις αποθηκεύονται αμέσως, το Ctrl+Z αναιρεί ένα βήμα, και ό,τι είναι λάθος αναφέρεται κάτω από το πεδίο του. Δίπλα στις σελίδες φαίνεται τι θα συναντήσει κάθε συμμετέχων.

Οι «Συνθήκες» ορίζουν τι συγκρίνεται, με ποιο έργο και ποια διαδικασία. Η «Αναμενόμενη ακρίβεια» εκτελεί τη μελέτη με προσομοιωμένους παρατηρητές και δείχνει την αναμενόμενη ακρίβεια, το πλήθος των δοκιμών και τον χρόνο. Ο «Έλεγχος και οριστικοποίηση» λέει τι λείπει, επιτρέπει σε κάποιον να δοκιμάσει το σχέδιο πιλοτικά και το οριστικοποιεί με το SHA-256 του· από τότε εγγράφονται συμμετέχοντες με τυχαίους κωδικούς και με τη συγκατάθεσή τους.</translation>
    </message>
    <message>
        <source>Expected precision</source>
        <translation>Αναμενόμενη ακρίβεια</translation>
    </message>
    <message>
        <source>Needed before it can be frozen: %1</source>
        <translation>Χρειάζεται πριν από την οριστικοποίηση: %1</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Επόμενο: %1</translation>
    </message>
    <message>
        <source>Next: correct “%1”</source>
        <translation>Επόμενο: διόρθωση «%1»</translation>
    </message>
    <message>
        <source>The simulation was stopped because you left its page, and nothing of it was kept. Press “Estimate the precision” there to calculate it again.</source>
        <translation>Η προσομοίωση διακόπηκε, επειδή φύγατε από τη σελίδα της, και τίποτα δεν διατηρήθηκε. Πατήστε εκεί «Εκτίμηση της ακρίβειας», για να υπολογιστεί ξανά.</translation>
    </message>
    <message>
        <source>cannot be frozen before the entries marked in red are corrected</source>
        <translation>δεν μπορεί να οριστικοποιηθεί πριν διορθωθούν οι καταχωρίσεις με κόκκινο</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TargetBar</name>
    <message>
        <source>below the band</source>
        <translation>κάτω από τη ζώνη</translation>
    </message>
    <message>
        <source>in the band</source>
        <translation>στη ζώνη</translation>
    </message>
    <message>
        <source>above the band</source>
        <translation>πάνω από τη ζώνη</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>πάνω από το όριο</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2, %3</source>
        <translation>%1 %2, %3</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TaskStrip</name>
    <message>
        <source>Progress</source>
        <translation>Πρόοδος</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Άκυρο</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Διακοπή …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrainingScreen</name>
    <message>
        <source>Scene</source>
        <translation>Σκηνή</translation>
    </message>
    <message>
        <source>Storing and scoring the session …</source>
        <translation>Αποθήκευση και βαθμολόγηση της συνεδρίας …</translation>
    </message>
    <message>
        <source>The session could not be run</source>
        <translation>Η συνεδρία δεν εκτελέστηκε</translation>
    </message>
    <message>
        <source>End the session now?</source>
        <translation>Να τερματιστεί τώρα η συνεδρία;</translation>
    </message>
    <message>
        <source>End the session</source>
        <translation>Τέλος συνεδρίας</translation>
    </message>
    <message>
        <source>A session is running. End it and leave?</source>
        <translation>Μια συνεδρία είναι σε εξέλιξη. Τερματισμός και έξοδος;</translation>
    </message>
    <message>
        <source>End and leave</source>
        <translation>Τερματισμός και έξοδος</translation>
    </message>
    <message>
        <source>Preparing the scene …</source>
        <translation>Προετοιμασία της σκηνής …</translation>
    </message>
    <message>
        <source>What is recorded is kept. The session counts as stopped, not as completed.</source>
        <translation>Όσα καταγράφηκαν διατηρούνται. Η συνεδρία θεωρείται ότι σταμάτησε, όχι ότι ολοκληρώθηκε.</translation>
    </message>
    <message>
        <source>Keep training</source>
        <translation>Συνέχεια εκπαίδευσης</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Εκπαίδευση</translation>
    </message>
    <message>
        <source>Stop force</source>
        <translation>Διακοπή δύναμης</translation>
    </message>
    <message>
        <source>Pause or go on</source>
        <translation>Παύση ή συνέχεια</translation>
    </message>
    <message>
        <source>Re-arm force</source>
        <translation>Ενεργοποίηση δύναμης</translation>
    </message>
    <message>
        <source>Mark this place</source>
        <translation>Σημείωση αυτής της θέσης</translation>
    </message>
    <message>
        <source>Sound on or off</source>
        <translation>Ήχος: ενεργός ή ανενεργός</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>What is recorded so far is kept and counts as stopped, not as completed. A new attempt begins at once.</source>
        <translation>Όσα καταγράφηκαν ως τώρα διατηρούνται και η συνεδρία θεωρείται ότι σταμάτησε, όχι ότι ολοκληρώθηκε. Μια νέα προσπάθεια αρχίζει αμέσως.</translation>
    </message>
    <message>
        <source>Start again from the beginning?</source>
        <translation>Επανέναρξη από την αρχή;</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Επανέναρξη</translation>
    </message>
    <message>
        <source>Depth of field (F)</source>
        <translation>Βάθος πεδίου (F)</translation>
    </message>
    <message>
        <source>Depth of field: this level keeps it on</source>
        <translation>Βάθος πεδίου: ενεργό σε αυτό το επίπεδο</translation>
    </message>
    <message>
        <source>Depth of field: this level keeps it off</source>
        <translation>Βάθος πεδίου: ανενεργό σε αυτό το επίπεδο</translation>
    </message>
    <message>
        <source>The picture is sharp at one distance only, as through a real endoscope</source>
        <translation>Η εικόνα είναι εστιασμένη σε μία μόνο απόσταση, όπως σε πραγματικό ενδοσκόπιο</translation>
    </message>
    <message>
        <source>When the procedure is done the debrief opens by itself.</source>
        <translation>Όταν ολοκληρωθεί η διαδικασία, ο απολογισμός ανοίγει μόνος του.</translation>
    </message>
    <message>
        <source>After the last trial the debrief opens by itself.</source>
        <translation>Μετά την τελευταία δοκιμή ο απολογισμός ανοίγει μόνος του.</translation>
    </message>
    <message>
        <source>This is where you train. The scene is on the left, the measurements are on the right and the controls are below. Each level shows only what belongs to it; what is hidden is still recorded.

%1

&quot;Stop force&quot; switches the force off at once and stops the clock. &quot;Re-arm&quot; brings the force back slowly. &quot;Pause&quot; keeps everything as it is. &quot;Start again&quot; keeps the attempt so far as stopped and begins a new one from the start.

%2</source>
        <translation>Εδώ εκπαιδεύεστε. Αριστερά βλέπετε τη σκηνή, δεξιά τις μετρήσεις, κάτω τα κουμπιά. Κάθε επίπεδο δείχνει μόνο όσα του ανήκουν· όσα κρύβονται καταγράφονται και αυτά.

%1

Η «Διακοπή δύναμης» διακόπτει αμέσως τη δύναμη και σταματά τον χρόνο. Η «Ενεργοποίηση» επαναφέρει τη δύναμη αργά. Η «Παύση» κρατά τα πάντα όπως είναι. Η «Επανέναρξη» διατηρεί την προσπάθεια ως τώρα, που θεωρείται ότι σταμάτησε, και αρχίζει μια νέα από την αρχή.

%2</translation>
    </message>
    <message>
        <source>Start again from the beginning</source>
        <translation>Επανέναρξη από την αρχή</translation>
    </message>
    <message>
        <source>Depth of field on or off</source>
        <translation>Βάθος πεδίου: ενεργό ή ανενεργό</translation>
    </message>
    <message>
        <source>Select the next finding</source>
        <translation>Επιλογή του επόμενου ευρήματος</translation>
    </message>
    <message>
        <source>Take back the selected finding</source>
        <translation>Απόσυρση του επιλεγμένου ευρήματος</translation>
    </message>
    <message>
        <source>Nothing more to report</source>
        <translation>Τίποτε άλλο για αναφορά</translation>
    </message>
    <message>
        <source>Free the pointer to rate with the mouse</source>
        <translation>Ελευθέρωση του δείκτη για βαθμολόγηση με το ποντίκι</translation>
    </message>
    <message>
        <source>Map: searched area or force</source>
        <translation>Χάρτης: περιοχή έρευνας ή δύναμη</translation>
    </message>
    <message>
        <source>Force is stopped</source>
        <translation>Η δύναμη σταμάτησε</translation>
    </message>
    <message>
        <source>The clock is stopped. Press Re-arm or R to go on.</source>
        <translation>Ο χρόνος έχει σταματήσει. Πατήστε «Ενεργοποίηση» ή R για να συνεχίσετε.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Σε παύση</translation>
    </message>
    <message>
        <source>The clock is stopped. Press Resume or Space to go on.</source>
        <translation>Ο χρόνος έχει σταματήσει. Πατήστε «Συνέχεια» ή Διάστημα για να συνεχίσετε.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s). The clock starts when you press Go or move the tool with a key.</source>
        <translation>
            <numerusform>%n δοκιμή. Το χρονόμετρο ξεκινά όταν πατήσετε «Έναρξη» ή κινήσετε το εργαλείο με ένα πλήκτρο.</numerusform>
            <numerusform>%n δοκιμές. Το χρονόμετρο ξεκινά όταν πατήσετε «Έναρξη» ή κινήσετε το εργαλείο με ένα πλήκτρο.</numerusform>
        </translation>
    </message>
    <message>
        <source>All measurements (F4)</source>
        <translation>Όλες οι μετρήσεις (F4)</translation>
    </message>
    <message>
        <source>Also shows single components, coordinates and further plots. Everything is recorded either way.</source>
        <translation>Δείχνει και επιμέρους συνιστώσες, συντεταγμένες και περισσότερα διαγράμματα. Καταγράφονται όλα σε κάθε περίπτωση.</translation>
    </message>
    <message>
        <source>All measurements, or those a trainee needs</source>
        <translation>Όλες οι μετρήσεις ή όσες χρειάζονται οι εκπαιδευόμενοι</translation>
    </message>
    <message>
        <source>The practice is over. The familiarisation begins when you press Continue; it does not count either.</source>
        <translation>Η εξάσκηση τελείωσε. Η εξοικείωση αρχίζει όταν πατήσετε «Συνέχεια»· ούτε αυτή μετράει.</translation>
    </message>
    <message>
        <source>The practice is over and does not count. The trials that count begin when you press Continue.</source>
        <translation>Η εξάσκηση τελείωσε και δεν μετράει. Οι δοκιμές που μετρούν αρχίζουν όταν πατήσετε «Συνέχεια».</translation>
    </message>
    <message>
        <source>Practice ends in %1 s</source>
        <translation>Η εξάσκηση τελειώνει σε %1 s</translation>
    </message>
    <message>
        <source>%1. %2.</source>
        <translation>%1. %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s). The clock starts when you press Continue.</source>
        <translation>
            <numerusform>%n δοκιμή. Το χρονόμετρο ξεκινά όταν πατήσετε «Συνέχεια».</numerusform>
            <numerusform>%n δοκιμές. Το χρονόμετρο ξεκινά όταν πατήσετε «Συνέχεια».</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Nothing counts yet.</source>
        <translation>%1 Τίποτα δεν μετράει ακόμη.</translation>
    </message>
    <message>
        <source>The mouse moves the instrument. Space pauses and frees it.</source>
        <translation>Το ποντίκι κινεί το εργαλείο. Το Διάστημα κάνει παύση και το ελευθερώνει.</translation>
    </message>
    <message>
        <source>Space frees the mouse</source>
        <translation>Το Διάστημα ελευθερώνει το ποντίκι</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s). The clock starts when you press Go.</source>
        <translation>
            <numerusform>%n δοκιμή. Το χρονόμετρο ξεκινά όταν πατήσετε «Έναρξη».</numerusform>
            <numerusform>%n δοκιμές. Το χρονόμετρο ξεκινά όταν πατήσετε «Έναρξη».</numerusform>
        </translation>
    </message>
    <message>
        <source>Click in the scene to go on</source>
        <translation>Κάντε κλικ στη σκηνή για να συνεχίσετε</translation>
    </message>
    <message>
        <source>Scroll down in the panel</source>
        <translation>Κύλιση του πίνακα προς τα κάτω</translation>
    </message>
    <message>
        <source>Scroll up in the panel</source>
        <translation>Κύλιση του πίνακα προς τα πάνω</translation>
    </message>
    <message>
        <source>The practice is paused. Press Resume or Space to go on.</source>
        <translation>Η εξάσκηση είναι σε παύση. Πατήστε «Συνέχεια» ή Διάστημα για να συνεχίσετε.</translation>
    </message>
    <message>
        <source>The trial is paused and its clock is stopped. Press Resume or Space to go on.</source>
        <translation>Η δοκιμή είναι σε παύση και ο χρόνος της έχει σταματήσει. Πατήστε «Συνέχεια» ή Διάστημα για να συνεχίσετε.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TransportBar</name>
    <message>
        <source>To the beginning (Home)</source>
        <translation>Στην αρχή (Home)</translation>
    </message>
    <message>
        <source>One frame back (Left)</source>
        <translation>Ένα καρέ πίσω (Αριστερά)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Έναρξη</translation>
    </message>
    <message>
        <source>One frame forward (Right)</source>
        <translation>Ένα καρέ εμπρός (Δεξιά)</translation>
    </message>
    <message>
        <source>To the end (End)</source>
        <translation>Στο τέλος (End)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Ταχύτητα</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Παύση</translation>
    </message>
    <message>
        <source>Skip pauses</source>
        <translation>Παράλειψη παύσεων</translation>
    </message>
    <message>
        <source>%1 of %2 in the recording, which begins before the first trial</source>
        <translation>%1 από %2 στην καταγραφή, που αρχίζει πριν από την πρώτη δοκιμή</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrialsPageOfRun</name>
    <message>
        <source>There are no runs yet.</source>
        <translation>Δεν υπάρχουν εκτελέσεις ακόμη.</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Δοκιμές</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Αρ.</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Διαφορά</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Απάντηση</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Μετρά</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Χρόνος (s)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>καμία</translation>
    </message>
    <message>
        <source>given</source>
        <translation>δόθηκε</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>λάθος</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Εξάσκηση</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>σωστό</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Δύναμη (N)</translation>
    </message>
    <message>
        <source>Number of the presentation</source>
        <translation>Αριθμός της παρουσίασης</translation>
    </message>
    <message>
        <source>By how much the object exceeded the reference</source>
        <translation>Πόσο ξεπερνούσε το αντικείμενο την αναφορά</translation>
    </message>
    <message>
        <source>Whether the trial counts, and if not, why</source>
        <translation>Αν η δοκιμή μετρά και, αν όχι, γιατί</translation>
    </message>
    <message>
        <source>Time until the answer</source>
        <translation>Χρόνος έως την απάντηση</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Μέγιστη δύναμη</translation>
    </message>
    <message>
        <source>Mean speed of the tool</source>
        <translation>Μέση ταχύτητα του εργαλείου</translation>
    </message>
    <message>
        <source>Share of late ticks</source>
        <translation>Ποσοστό καθυστερημένων κύκλων</translation>
    </message>
    <message>
        <source>How far the felt value was from the requested one</source>
        <translation>Πόσο απείχε η τιμή που αποδόθηκε από τη ζητούμενη</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Ταχύτητα (mm/s)</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Αργοί κύκλοι</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Απόκλιση</translation>
    </message>
    <message>
        <source>What the participant answered</source>
        <translation>Τι απάντησε το άτομο</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrialsScreen</name>
    <message>
        <source>Study</source>
        <translation>Μελέτη</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>Συμμετέχων %1</translation>
    </message>
    <message>
        <source>Reading the study …</source>
        <translation>Ανάγνωση της μελέτης …</translation>
    </message>
    <message>
        <source>Before you begin</source>
        <translation>Πριν αρχίσετε</translation>
    </message>
    <message>
        <source>Participant %1 · practice</source>
        <translation>Συμμετέχων %1 · εξάσκηση</translation>
    </message>
    <message>
        <source>Correct.</source>
        <translation>Σωστά.</translation>
    </message>
    <message>
        <source>Wrong.</source>
        <translation>Λάθος.</translation>
    </message>
    <message>
        <source>The time to explore is over. Answer now.</source>
        <translation>Ο χρόνος εξερεύνησης τελείωσε. Απαντήστε τώρα.</translation>
    </message>
    <message>
        <source>One moment …</source>
        <translation>Μια στιγμή …</translation>
    </message>
    <message>
        <source>Break</source>
        <translation>Διάλειμμα</translation>
    </message>
    <message numerus="yes">
        <source>Rest your hand. You can continue in %n second(s).</source>
        <translation>
            <numerusform>Ξεκουράστε το χέρι σας. Μπορείτε να συνεχίσετε σε %n δευτερόλεπτο.</numerusform>
            <numerusform>Ξεκουράστε το χέρι σας. Μπορείτε να συνεχίσετε σε %n δευτερόλεπτα.</numerusform>
        </translation>
    </message>
    <message>
        <source>Continue when you are ready.</source>
        <translation>Συνεχίστε όταν είστε έτοιμοι.</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Συνέχεια</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Σε παύση</translation>
    </message>
    <message>
        <source>Stop this session?</source>
        <translation>Διακοπή της συνεδρίας;</translation>
    </message>
    <message>
        <source>This condition is completed.</source>
        <translation>Η συνθήκη ολοκληρώθηκε.</translation>
    </message>
    <message>
        <source>The session could not be run</source>
        <translation>Η συνεδρία δεν εκτελέστηκε</translation>
    </message>
    <message>
        <source>Pause or go on</source>
        <translation>Παύση ή συνέχεια</translation>
    </message>
    <message>
        <source>Stop the session</source>
        <translation>Διακοπή της συνεδρίας</translation>
    </message>
    <message>
        <source>Progress of this part</source>
        <translation>Πρόοδος αυτού του μέρους</translation>
    </message>
    <message>
        <source>Time to explore</source>
        <translation>Χρόνος εξερεύνησης</translation>
    </message>
    <message>
        <source>%1 mm from the highest point.</source>
        <translation>%1 mm από το ψηλότερο σημείο.</translation>
    </message>
    <message>
        <source>Click or press Enter at the highest point.</source>
        <translation>Κάντε κλικ ή πατήστε Enter στο ψηλότερο σημείο.</translation>
    </message>
    <message>
        <source>The sphere is too stiff for this device: the study asks for %1 N/m, but with its delay the device can render at most %2 N/m stably. Use a faster device, or plan a softer sphere in another study.</source>
        <translation>Η σφαίρα είναι πολύ δύσκαμπτη για αυτή τη συσκευή: ζητούνται %1 N/m, αλλά με την καθυστέρησή της αποδίδει σταθερά το πολύ %2 N/m. Χρησιμοποιήστε ταχύτερη συσκευή ή σχεδιάστε μαλακότερη σφαίρα σε άλλη μελέτη.</translation>
    </message>
    <message>
        <source>Not possible with this device</source>
        <translation>Δεν γίνεται με αυτή τη συσκευή</translation>
    </message>
    <message>
        <source>Because of its delay, this device can render none of the differences in this condition. Use a faster or stronger device, or plan another reference in another study.</source>
        <translation>Λόγω της καθυστέρησής της, η συσκευή δεν αποδίδει καμία από τις διαφορές αυτής της συνθήκης. Χρησιμοποιήστε ταχύτερη ή ισχυρότερη συσκευή ή σχεδιάστε άλλη αναφορά σε άλλη μελέτη.</translation>
    </message>
    <message>
        <source>This run was started on a device that renders larger differences than this one. It can be continued only with such a device, so that all of its trials can be compared.</source>
        <translation>Αυτή η εκτέλεση άρχισε σε συσκευή που αποδίδει μεγαλύτερες διαφορές από αυτή. Συνεχίζεται μόνο με τέτοια συσκευή, ώστε όλες οι δοκιμές της να είναι συγκρίσιμες.</translation>
    </message>
    <message>
        <source>This run was started with a different version of its procedure. A run is never continued with another version, so that all of its trials can be compared. The answers so far are kept; enrol another participant for this condition.</source>
        <translation>Αυτή η εκτέλεση άρχισε με άλλη έκδοση της διαδικασίας της. Μια εκτέλεση δεν συνεχίζεται ποτέ με άλλη έκδοση, ώστε όλες οι δοκιμές να είναι συγκρίσιμες. Οι ως τώρα απαντήσεις διατηρούνται· εγγράψτε άλλον συμμετέχοντα για αυτή τη συνθήκη.</translation>
    </message>
    <message>
        <source>This is how you explore and answer</source>
        <translation>Έτσι εξερευνάτε και απαντάτε</translation>
    </message>
    <message>
        <source>Where is the highest point?</source>
        <translation>Πού είναι το υψηλότερο σημείο;</translation>
    </message>
    <message>
        <source>First comes a free minute to try the controls. Nothing counts in it, and you can end it at any time.</source>
        <translation>Πρώτα υπάρχει ένα ελεύθερο λεπτό για να δοκιμάσετε τον χειρισμό. Τίποτα δεν μετράει σε αυτό και μπορείτε να το τερματίσετε όποτε θέλετε.</translation>
    </message>
    <message>
        <source>The trials go on where they were interrupted.</source>
        <translation>Οι δοκιμές συνεχίζονται από εκεί που διακόπηκαν.</translation>
    </message>
    <message>
        <source>The session could not be run.</source>
        <translation>Η συνεδρία δεν ήταν δυνατό να εκτελεστεί.</translation>
    </message>
    <message>
        <source>Experimenter</source>
        <translation>Πειραματιστής</translation>
    </message>
    <message>
        <source>Go on with the study</source>
        <translation>Συνέχιση της μελέτης</translation>
    </message>
    <message>
        <source>Masking sound</source>
        <translation>Ήχος κάλυψης</translation>
    </message>
    <message>
        <source>Whether it is on is stored with each trial</source>
        <translation>Αν είναι ενεργός αποθηκεύεται με κάθε δοκιμή</translation>
    </message>
    <message>
        <source>Experimenter …</source>
        <translation>Πειραματιστής …</translation>
    </message>
    <message>
        <source>Take back (⌫)</source>
        <translation>Αναίρεση (⌫)</translation>
    </message>
    <message>
        <source>Next (Enter)</source>
        <translation>Επόμενο (Enter)</translation>
    </message>
    <message>
        <source>The participant&apos;s page is on the other screen.</source>
        <translation>Η σελίδα του συμμετέχοντα βρίσκεται στην άλλη οθόνη.</translation>
    </message>
    <message>
        <source>The session is paused. Before you hand over, go back to the participant&apos;s page.</source>
        <translation>Η συνεδρία είναι σε παύση. Πριν παραδώσετε, επιστρέψτε στη σελίδα του συμμετέχοντα.</translation>
    </message>
    <message>
        <source>Please call the experimenter.</source>
        <translation>Παρακαλούμε καλέστε τον πειραματιστή.</translation>
    </message>
    <message>
        <source>Participant %1 · free minute</source>
        <translation>Συμμετέχων %1 · ελεύθερο λεπτό</translation>
    </message>
    <message numerus="yes">
        <source>Free minute: try the controls. Nothing counts yet. %n second(s) left.</source>
        <translation>
            <numerusform>Ελεύθερο λεπτό: δοκιμάστε τον χειρισμό. Τίποτα δεν μετράει ακόμη. Απομένει %n δευτερόλεπτο.</numerusform>
            <numerusform>Ελεύθερο λεπτό: δοκιμάστε τον χειρισμό. Τίποτα δεν μετράει ακόμη. Απομένουν %n δευτερόλεπτα.</numerusform>
        </translation>
    </message>
    <message>
        <source>I am ready (Enter)</source>
        <translation>Είμαι έτοιμος/-η (Enter)</translation>
    </message>
    <message>
        <source>Touch the object first.</source>
        <translation>Αγγίξτε πρώτα το αντικείμενο.</translation>
    </message>
    <message>
        <source>Touch first: %1.</source>
        <translation>Αγγίξτε πρώτα: %1.</translation>
    </message>
    <message>
        <source>Pilot run</source>
        <translation>Πιλοτική δοκιμή</translation>
    </message>
    <message>
        <source>The free minute is over</source>
        <translation>Το ελεύθερο λεπτό τελείωσε</translation>
    </message>
    <message>
        <source>The masking sound is not heard: this machine has no sound output. Each trial is recorded as not masked. To mask, stop the session, connect headphones or loudspeakers, and resume the run.</source>
        <translation>Ο ήχος κάλυψης δεν ακούγεται: αυτός ο υπολογιστής δεν έχει έξοδο ήχου. Κάθε δοκιμή καταγράφεται ως χωρίς κάλυψη. Για κάλυψη σταματήστε τη συνεδρία, συνδέστε ακουστικά ή ηχεία και συνεχίστε την εκτέλεση.</translation>
    </message>
    <message>
        <source>%1 The participant is now answering the questions about it.</source>
        <translation>%1 Ο συμμετέχων απαντά τώρα στις ερωτήσεις για αυτήν.</translation>
    </message>
    <message numerus="yes">
        <source>The free minute ends in %n second(s). Then you say when the trials begin.</source>
        <translation>
            <numerusform>Το ελεύθερο λεπτό τελειώνει σε %n δευτερόλεπτο. Μετά λέτε εσείς πότε αρχίζουν οι δοκιμές.</numerusform>
            <numerusform>Το ελεύθερο λεπτό τελειώνει σε %n δευτερόλεπτα. Μετά λέτε εσείς πότε αρχίζουν οι δοκιμές.</numerusform>
        </translation>
    </message>
    <message>
        <source>What you tried does not count. Practice trials come next, and they do not count either; after them every answer counts. Press Continue when you are ready.</source>
        <translation>Ό,τι δοκιμάσατε δεν μετράει. Ακολουθούν δοκιμές εξάσκησης, που ούτε αυτές μετρούν· μετά από αυτές μετράει κάθε απάντηση. Πατήστε «Συνέχεια» όταν είστε έτοιμοι.</translation>
    </message>
    <message>
        <source>You moved too fast. Move more slowly.</source>
        <translation>Κινηθήκατε πολύ γρήγορα. Κινηθείτε πιο αργά.</translation>
    </message>
    <message>
        <source>You pulled too hard. Pull more gently.</source>
        <translation>Τραβήξατε πολύ δυνατά. Τραβήξτε πιο απαλά.</translation>
    </message>
    <message>
        <source>You pressed too hard. Press more gently.</source>
        <translation>Πιέσατε πολύ δυνατά. Πιέστε πιο απαλά.</translation>
    </message>
    <message>
        <source>The next part</source>
        <translation>Το επόμενο μέρος</translation>
    </message>
    <message>
        <source>Read the whole instruction again</source>
        <translation>Ανάγνωση όλων των οδηγιών ξανά</translation>
    </message>
    <message>
        <source>The pilot run is over</source>
        <translation>Η πιλοτική δοκιμή τελείωσε</translation>
    </message>
    <message>
        <source>What was tried does not count as data of the study.</source>
        <translation>Όσα δοκιμάστηκαν δεν ανήκουν στα δεδομένα της μελέτης.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Συνέχεια</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>Δοκιμή %1</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <translation>Δοκιμή %1 από %2</translation>
    </message>
    <message>
        <source>Trial %1 of at most %2</source>
        <translation>Δοκιμή %1 από το πολύ %2</translation>
    </message>
    <message>
        <source>Practice: nothing counts yet.</source>
        <translation>Εξάσκηση: τίποτα δεν μετρά ακόμη.</translation>
    </message>
    <message>
        <source>Pull a little harder: at least %1 N.</source>
        <translation>Τραβήξτε λίγο πιο δυνατά: τουλάχιστον %1 N.</translation>
    </message>
    <message>
        <source>Press a little harder: at least %1 N.</source>
        <translation>Πιέστε λίγο πιο δυνατά: τουλάχιστον %1 N.</translation>
    </message>
    <message>
        <source>Pull a little harder on %1: at least %2 N.</source>
        <translation>Τραβήξτε λίγο πιο δυνατά το %1: τουλάχιστον %2 N.</translation>
    </message>
    <message>
        <source>Press a little harder on %1: at least %2 N.</source>
        <translation>Πιέστε λίγο πιο δυνατά το %1: τουλάχιστον %2 N.</translation>
    </message>
    <message>
        <source>Practice is over</source>
        <translation>Η εξάσκηση τελείωσε</translation>
    </message>
    <message>
        <source>Continue (Enter)</source>
        <translation>Συνέχεια (Enter)</translation>
    </message>
    <message>
        <source>Stop … (Esc twice)</source>
        <translation>Διακοπή … (δύο φορές Esc)</translation>
    </message>
    <message>
        <source>It comes again later.</source>
        <translation>Θα επαναληφθεί αργότερα.</translation>
    </message>
    <message>
        <source>The same objects come again.</source>
        <translation>Τα ίδια αντικείμενα έρχονται ξανά.</translation>
    </message>
    <message>
        <source>No answer came in time.</source>
        <translation>Δεν δόθηκε απάντηση εγκαίρως.</translation>
    </message>
    <message>
        <source>The last trial did not count. %1 %2</source>
        <translation>Η τελευταία δοκιμή δεν μέτρησε. %1 %2</translation>
    </message>
    <message>
        <source>The clock is stopped and everything so far is kept. Press R to go on, or Esc to stop the session.</source>
        <translation>Ο χρόνος έχει σταματήσει και όλα ως τώρα διατηρούνται. Πατήστε R για συνέχεια ή Esc για διακοπή της συνεδρίας.</translation>
    </message>
    <message>
        <source>Here a participant explores objects and answers.</source>
        <translation>Εδώ ένας συμμετέχων εξερευνά αντικείμενα και απαντά.</translation>
    </message>
    <message>
        <source>In practice, Backspace takes an answer back.</source>
        <translation>Στην εξάσκηση, το Backspace αναιρεί μια απάντηση.</translation>
    </message>
    <message>
        <source>F2 is for the experimenter.</source>
        <translation>Το F2 είναι για τον πειραματιστή.</translation>
    </message>
    <message>
        <source>What was tried in a pilot run does not count as data of the study, and a stopped pilot run is not continued.</source>
        <translation>Όσα δοκιμάστηκαν σε πιλοτική δοκιμή δεν ανήκουν στα δεδομένα της μελέτης, και μια πιλοτική δοκιμή που διακόπηκε δεν συνεχίζεται.</translation>
    </message>
    <message>
        <source>Stop this pilot run?</source>
        <translation>Διακοπή της πιλοτικής δοκιμής;</translation>
    </message>
    <message>
        <source>The pilot run reached its end.</source>
        <translation>Η πιλοτική δοκιμή έφτασε στο τέλος της.</translation>
    </message>
    <message>
        <source>The session ended by itself before all trials were done, and nothing more was presented. Check the device before you go on.</source>
        <translation>Η συνεδρία τελείωσε από μόνη της πριν γίνουν όλες οι δοκιμές, και δεν παρουσιάστηκε τίποτε άλλο. Ελέγξτε τη συσκευή πριν συνεχίσετε.</translation>
    </message>
    <message>
        <source>%1. From now on every answer counts.</source>
        <translation>%1. Από εδώ και πέρα μετράει κάθε απάντηση.</translation>
    </message>
    <message>
        <source>You let go of the object. Raise the tool.</source>
        <translation>Αφήσατε το αντικείμενο. Σηκώστε το εργαλείο.</translation>
    </message>
    <message>
        <source>You let go of object %1. Raise the tool.</source>
        <translation>Αφήσατε το αντικείμενο %1. Σηκώστε το εργαλείο.</translation>
    </message>
    <message>
        <source>Touch next: %1.</source>
        <translation>Αγγίξτε μετά: %1.</translation>
    </message>
    <message>
        <source>Find the highest point, and mark it.</source>
        <translation>Βρείτε το υψηλότερο σημείο και σημειώστε το.</translation>
    </message>
    <message>
        <source>Find the sphere first.</source>
        <translation>Βρείτε πρώτα τη σφαίρα.</translation>
    </message>
    <message>
        <source>Move the tool with the device, or with the mouse; with the mouse, raise and lower it with the wheel or Page Up and Page Down. T frees the pointer, and a click in the scene captures it again and does not count as an answer. Answer with the buttons or with the keys shown on them, as soon as they are enabled.</source>
        <translation>Μετακινήστε το εργαλείο με τη συσκευή ή με το ποντίκι· με το ποντίκι ανεβάζετε και κατεβάζετε με τον τροχό ή με τα Page Up και Page Down. Το T ελευθερώνει τον δείκτη, ένα κλικ στη σκηνή τον δεσμεύει ξανά και δεν μετράει ως απάντηση. Απαντήστε με τα κουμπιά ή με τα πλήκτρα που αναγράφονται σε αυτά, μόλις ενεργοποιηθούν.</translation>
    </message>
    <message>
        <source>What you do may differ from the previous part: the next page shows the question and how you answer it.</source>
        <translation>Αυτό που κάνετε μπορεί να διαφέρει από το προηγούμενο μέρος: η επόμενη σελίδα δείχνει την ερώτηση και πώς απαντάτε.</translation>
    </message>
    <message>
        <source>Apart from this, you explore and answer as in the previous part.</source>
        <translation>Κατά τα άλλα εξερευνάτε και απαντάτε όπως στο προηγούμενο μέρος.</translation>
    </message>
    <message>
        <source>You explore and answer as in the previous part, unless the experimenter tells you otherwise.</source>
        <translation>Εξερευνάτε και απαντάτε όπως στο προηγούμενο μέρος, εκτός αν σας πει κάτι άλλο ο πειραματιστής.</translation>
    </message>
    <message>
        <source>The number of trials may differ.</source>
        <translation>Ο αριθμός των δοκιμών μπορεί να διαφέρει.</translation>
    </message>
    <message numerus="yes">
        <source>First come %n practice trial(s), which do not count.</source>
        <translation>
            <numerusform>Στην αρχή υπάρχει %n δοκιμή εξάσκησης, που δεν μετρά.</numerusform>
            <numerusform>Στην αρχή υπάρχουν %n δοκιμές εξάσκησης, που δεν μετρούν.</numerusform>
        </translation>
    </message>
    <message>
        <source>The answer was not accepted. Please answer again, and call the experimenter if this happens once more.</source>
        <translation>Η απάντηση δεν έγινε δεκτή. Απαντήστε ξανά και καλέστε τον πειραματιστή αν συμβεί άλλη μία φορά.</translation>
    </message>
    <message>
        <source>The participant&apos;s screen is no longer connected. The session is paused, and everything so far is kept. The participant&apos;s page is in this window now.</source>
        <translation>Η οθόνη του συμμετέχοντα δεν είναι πλέον συνδεδεμένη. Η συνεδρία είναι σε παύση και ό,τι έγινε ως τώρα έχει διατηρηθεί. Η σελίδα του συμμετέχοντα βρίσκεται πλέον σε αυτό το παράθυρο.</translation>
    </message>
    <message>
        <source>The experimenter discarded it.</source>
        <translation>Την απέρριψε ο πειραματιστής.</translation>
    </message>
    <message>
        <source>The device did not work accurately enough. This was not your fault.</source>
        <translation>Η συσκευή δεν λειτούργησε με αρκετή ακρίβεια. Αυτό δεν οφείλεται σε εσάς.</translation>
    </message>
    <message>
        <source>You will answer here once the trials begin.</source>
        <translation>Εδώ θα απαντάτε, μόλις ξεκινήσουν οι δοκιμές.</translation>
    </message>
    <message>
        <source>Hold still for a moment, then you can go on.</source>
        <translation>Μείνετε ακίνητοι για μια στιγμή και μετά συνεχίζετε.</translation>
    </message>
    <message>
        <source>Please call the experimenter</source>
        <translation>Παρακαλούμε καλέστε τον πειραματιστή</translation>
    </message>
    <message>
        <source>Go on (R)</source>
        <translation>Συνέχεια (R)</translation>
    </message>
    <message>
        <source>The clock is stopped and everything so far is kept. Press Continue to go on.</source>
        <translation>Ο χρόνος έχει σταματήσει και όλα ως τώρα διατηρούνται. Πατήστε «Συνέχεια» για να συνεχίσετε.</translation>
    </message>
    <message>
        <source>Back to the study</source>
        <translation>Πίσω στη μελέτη</translation>
    </message>
    <message>
        <source>Back to the participant&apos;s conditions</source>
        <translation>Πίσω στις συνθήκες του συμμετέχοντα</translation>
    </message>
    <message>
        <source>Back to the participant&apos;s page (F2)</source>
        <translation>Πίσω στη σελίδα του συμμετέχοντα (F2)</translation>
    </message>
    <message>
        <source>The participant&apos;s screen is no longer connected. The participant&apos;s page is in this window now.</source>
        <translation>Η οθόνη του συμμετέχοντα δεν είναι πλέον συνδεδεμένη. Η σελίδα του συμμετέχοντα βρίσκεται πλέον σε αυτό το παράθυρο.</translation>
    </message>
    <message>
        <source>The session is paused. Enter your password to see the experimenter&apos;s view.</source>
        <translation>Η συνεδρία είναι σε παύση. Εισαγάγετε τον κωδικό πρόσβασής σας για να δείτε την προβολή του πειραματιστή.</translation>
    </message>
    <message>
        <source>The session is over. Enter your password to go on with the study.</source>
        <translation>Η συνεδρία τελείωσε. Εισαγάγετε τον κωδικό πρόσβασής σας για να συνεχίσετε τη μελέτη.</translation>
    </message>
    <message>
        <source>The session was stopped</source>
        <translation>Η συνεδρία διακόπηκε</translation>
    </message>
    <message>
        <source>This part is not finished; your answers so far are kept. Please call the experimenter, who decides when it goes on.</source>
        <translation>Αυτό το μέρος δεν ολοκληρώθηκε· οι απαντήσεις σας ως τώρα έχουν διατηρηθεί. Παρακαλούμε καλέστε τον πειραματιστή, που αποφασίζει πότε θα συνεχιστεί.</translation>
    </message>
    <message>
        <source>This part is finished</source>
        <translation>Αυτό το μέρος ολοκληρώθηκε</translation>
    </message>
    <message numerus="yes">
        <source>Thank you. %n more part(s) follow. Please call the experimenter, who decides when the next one begins.</source>
        <translation>
            <numerusform>Ευχαριστούμε. Ακολουθεί ακόμη %n μέρος. Παρακαλούμε καλέστε τον πειραματιστή, που αποφασίζει πότε αρχίζει το επόμενο.</numerusform>
            <numerusform>Ευχαριστούμε. Ακολουθούν ακόμη %n μέρη. Παρακαλούμε καλέστε τον πειραματιστή, που αποφασίζει πότε αρχίζει το επόμενο.</numerusform>
        </translation>
    </message>
    <message>
        <source>All trials are finished</source>
        <translation>Όλες οι δοκιμές ολοκληρώθηκαν</translation>
    </message>
    <message>
        <source>Thank you. Only a few questions about the study are left. Please call the experimenter, who opens them.</source>
        <translation>Ευχαριστούμε. Ακολουθούν μόνο μερικές ερωτήσεις για τη μελέτη. Παρακαλούμε καλέστε τον πειραματιστή, που θα τις ανοίξει.</translation>
    </message>
    <message>
        <source>Everything is finished</source>
        <translation>Όλα ολοκληρώθηκαν</translation>
    </message>
    <message>
        <source>Thank you. Nothing more is left for you to do in this study. Please call the experimenter.</source>
        <translation>Ευχαριστούμε. Δεν απομένει τίποτε άλλο να κάνετε σε αυτή τη μελέτη. Παρακαλούμε καλέστε τον πειραματιστή.</translation>
    </message>
    <message>
        <source>Practice: this answer does not count. Press Next to go on, or take it back if it was a slip.</source>
        <translation>Εξάσκηση: αυτή η απάντηση δεν μετράει. Πατήστε «Επόμενο» για να συνεχίσετε, ή αναιρέστε την αν έγινε κατά λάθος.</translation>
    </message>
    <message>
        <source>You are holding the object.</source>
        <translation>Κρατάτε το αντικείμενο.</translation>
    </message>
    <message>
        <source>You are holding object %1.</source>
        <translation>Κρατάτε το αντικείμενο %1.</translation>
    </message>
    <message>
        <source>Pull less hard.</source>
        <translation>Τραβήξτε λιγότερο δυνατά.</translation>
    </message>
    <message>
        <source>Press less hard.</source>
        <translation>Πιέστε λιγότερο δυνατά.</translation>
    </message>
    <message>
        <source>Pull less hard in this trial.</source>
        <translation>Τραβήξτε λιγότερο δυνατά σε αυτή τη δοκιμή.</translation>
    </message>
    <message>
        <source>Press less hard in this trial.</source>
        <translation>Πιέστε λιγότερο δυνατά σε αυτή τη δοκιμή.</translation>
    </message>
    <message>
        <source>All answers given so far are kept. The run is not finished: it can be resumed later at the same trial, also on another day. If it is not resumed, the answers count in the results as far as they suffice for a value.</source>
        <translation>Όλες οι απαντήσεις ως τώρα διατηρούνται. Η εκτέλεση δεν έχει ολοκληρωθεί: μπορεί να συνεχιστεί αργότερα από την ίδια δοκιμή, και άλλη μέρα. Αν δεν συνεχιστεί, οι απαντήσεις μετρούν στα αποτελέσματα, εφόσον επαρκούν για μια τιμή.</translation>
    </message>
    <message>
        <source>Go on with the trials</source>
        <translation>Συνέχεια των δοκιμών</translation>
    </message>
    <message>
        <source>Stop the pilot run</source>
        <translation>Τερματισμός της πιλοτικής δοκιμής</translation>
    </message>
    <message>
        <source>Stop, and keep the answers</source>
        <translation>Τερματισμός, με διατήρηση των απαντήσεων</translation>
    </message>
    <message>
        <source>the mark</source>
        <translation>το σημείο</translation>
    </message>
    <message>
        <source>Take back: %1 (⌫)</source>
        <translation>Αναίρεση: %1 (⌫)</translation>
    </message>
    <message>
        <source>Pull it up: roll the wheel away from you, or hold Page Up.</source>
        <translation>Τραβήξτε το προς τα πάνω: γυρίστε τον τροχό προς τα εμπρός ή κρατήστε το Page Up.</translation>
    </message>
    <message>
        <source>Pull it up.</source>
        <translation>Τραβήξτε το προς τα πάνω.</translation>
    </message>
    <message>
        <source>Press the object less hard onto the table.</source>
        <translation>Πιέστε το αντικείμενο λιγότερο δυνατά στο τραπέζι.</translation>
    </message>
    <message>
        <source>Press the object less hard onto the table in this trial.</source>
        <translation>Πιέστε το αντικείμενο λιγότερο δυνατά στο τραπέζι σε αυτή τη δοκιμή.</translation>
    </message>
    <message>
        <source>You pressed an object too hard onto the table. Put it down more gently.</source>
        <translation>Πιέσατε ένα αντικείμενο πολύ δυνατά στο τραπέζι. Ακουμπήστε το πιο απαλά.</translation>
    </message>
    <message>
        <source>Raise the tool: roll the wheel away from you, or hold Page Up.</source>
        <translation>Σηκώστε το εργαλείο: γυρίστε τον τροχό προς τα εμπρός ή κρατήστε το Page Up.</translation>
    </message>
    <message>
        <source>Raise the handle.</source>
        <translation>Σηκώστε τη λαβή.</translation>
    </message>
    <message>
        <source>You are pressing the object.</source>
        <translation>Πιέζετε το αντικείμενο.</translation>
    </message>
    <message>
        <source>You are touching the object. Move the mouse to stroke it.</source>
        <translation>Αγγίζετε το αντικείμενο. Μετακινήστε το ποντίκι για να το τρίψετε.</translation>
    </message>
    <message>
        <source>You are touching the object. Move the handle to stroke it.</source>
        <translation>Αγγίζετε το αντικείμενο. Μετακινήστε τη λαβή για να σύρετε το εργαλείο πάνω του.</translation>
    </message>
    <message>
        <source>Lift the object first.</source>
        <translation>Σηκώστε πρώτα το αντικείμενο.</translation>
    </message>
    <message>
        <source>Lift first: %1.</source>
        <translation>Σηκώστε πρώτα: %1.</translation>
    </message>
    <message>
        <source>Lift next: %1.</source>
        <translation>Σηκώστε στη συνέχεια: %1.</translation>
    </message>
    <message>
        <source>Pull the object first.</source>
        <translation>Τραβήξτε πρώτα το αντικείμενο.</translation>
    </message>
    <message>
        <source>Pull first: %1.</source>
        <translation>Τραβήξτε πρώτα: %1.</translation>
    </message>
    <message>
        <source>Pull next: %1.</source>
        <translation>Τραβήξτε στη συνέχεια: %1.</translation>
    </message>
    <message>
        <source>You can answer now, or explore further.</source>
        <translation>Μπορείτε να απαντήσετε τώρα ή να συνεχίσετε την εξερεύνηση.</translation>
    </message>
    <message>
        <source>You can answer now.</source>
        <translation>Μπορείτε να απαντήσετε τώρα.</translation>
    </message>
    <message>
        <source>You have not let go of an object yet, which you need for the next one.</source>
        <translation>Δεν έχετε αφήσει ακόμη κανένα αντικείμενο, πράγμα που χρειάζεται για το επόμενο.</translation>
    </message>
    <message>
        <source>Roll the wheel away from you, or hold Page Up.</source>
        <translation>Γυρίστε τον τροχό προς τα εμπρός ή κρατήστε το Page Up.</translation>
    </message>
    <message>
        <source>Roll the wheel towards you, or hold Page Down.</source>
        <translation>Γυρίστε τον τροχό προς τα πίσω ή κρατήστε το Page Down.</translation>
    </message>
    <message>
        <source>The pointer is free: click in the scene to move the tool with the mouse again.</source>
        <translation>Ο δείκτης είναι ελεύθερος: κάντε κλικ στη σκηνή για να μετακινείτε πάλι το εργαλείο με το ποντίκι.</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>ακόμη %1&#xa0;s</translation>
    </message>
    <message>
        <source>Lower the tool until the force rises: roll the wheel towards you, or hold Page Down.</source>
        <translation>Κατεβάστε το εργαλείο ώσπου να αυξηθεί η δύναμη: γυρίστε τον τροχό προς τα πίσω ή κρατήστε το Page Down.</translation>
    </message>
    <message>
        <source>Lower the tip until it meets the sphere.</source>
        <translation>Κατεβάστε την άκρη ώσπου να συναντήσει τη σφαίρα.</translation>
    </message>
    <message>
        <source>The time ended while you were still holding an object: put it down and let go of it to lift the next one.</source>
        <translation>Ο χρόνος τελείωσε ενώ κρατούσατε ακόμη ένα αντικείμενο: ακουμπήστε το και αφήστε το, για να σηκώσετε το επόμενο.</translation>
    </message>
    <message>
        <source>The time ended while you were still holding an object: let go of it to explore the next one.</source>
        <translation>Ο χρόνος τελείωσε ενώ κρατούσατε ακόμη ένα αντικείμενο: αφήστε το, για να εξερευνήσετε το επόμενο.</translation>
    </message>
    <message>
        <source>The time ended before every object was lifted: one of them was held, but stayed on the table.</source>
        <translation>Ο χρόνος τελείωσε πριν σηκωθούν όλα τα αντικείμενα: ένα από αυτά το κρατήσατε, αλλά έμεινε στο τραπέζι.</translation>
    </message>
    <message>
        <source>The time ended before every object was lifted.</source>
        <translation>Ο χρόνος τελείωσε πριν σηκωθούν όλα τα αντικείμενα.</translation>
    </message>
    <message>
        <source>You did not pull every object hard enough in time: at least %1 N.</source>
        <translation>Δεν τραβήξατε εγκαίρως όλα τα αντικείμενα αρκετά δυνατά: τουλάχιστον %1 N.</translation>
    </message>
    <message>
        <source>You did not press every object hard enough in time: at least %1 N.</source>
        <translation>Δεν πιέσατε εγκαίρως όλα τα αντικείμενα αρκετά δυνατά: τουλάχιστον %1 N.</translation>
    </message>
    <message>
        <source>The time ended before every object was pulled.</source>
        <translation>Ο χρόνος τελείωσε πριν τραβήξετε όλα τα αντικείμενα.</translation>
    </message>
    <message>
        <source>The time ended before every object was touched.</source>
        <translation>Ο χρόνος τελείωσε πριν αγγίξετε όλα τα αντικείμενα.</translation>
    </message>
    <message>
        <source>%1 This practice trial comes again.</source>
        <translation>%1 Αυτή η δοκιμή εξάσκησης θα επαναληφθεί.</translation>
    </message>
    <message>
        <source>The next objects are coming.</source>
        <translation>Έρχονται τα επόμενα αντικείμενα.</translation>
    </message>
    <message>
        <source>These objects come again.</source>
        <translation>Αυτά τα αντικείμενα θα παρουσιαστούν ξανά.</translation>
    </message>
    <message>
        <source>The next sphere is coming.</source>
        <translation>Έρχεται η επόμενη σφαίρα.</translation>
    </message>
    <message>
        <source>Unlike in practice, the next trial comes by itself after each answer: there is no Next, and no answer can be taken back. Press Continue when you are ready.</source>
        <translation>Αντίθετα με την εξάσκηση, μετά από κάθε απάντηση η επόμενη δοκιμή έρχεται μόνη της: δεν υπάρχει «Επόμενο», και καμία απάντηση δεν μπορεί να αναιρεθεί. Πατήστε «Συνέχεια» όταν είστε έτοιμοι.</translation>
    </message>
    <message>
        <source>The next trial comes by itself after each answer, and no answer can be taken back. Press Continue when you are ready.</source>
        <translation>Μετά από κάθε απάντηση η επόμενη δοκιμή έρχεται μόνη της, και καμία απάντηση δεν μπορεί να αναιρεθεί. Πατήστε «Συνέχεια» όταν είστε έτοιμοι.</translation>
    </message>
    <message>
        <source>What you tried does not count. From now on every answer counts.</source>
        <translation>Ό,τι δοκιμάσατε δεν μετράει. Από εδώ και πέρα μετράει κάθε απάντηση.</translation>
    </message>
    <message>
        <source>Several trials in a row did not count. The last one: %1</source>
        <translation>Αρκετές δοκιμές στη σειρά δεν μέτρησαν. Η τελευταία: %1</translation>
    </message>
    <message>
        <source>Ask the experimenter to show how an object is explored and let go.</source>
        <translation>Ζητήστε από τον πειραματιστή να σας δείξει πώς εξερευνάται και πώς αφήνεται ένα αντικείμενο.</translation>
    </message>
    <message>
        <source>Ask the experimenter to show how an object is explored.</source>
        <translation>Ζητήστε από τον πειραματιστή να σας δείξει πώς εξερευνάται ένα αντικείμενο.</translation>
    </message>
    <message>
        <source>The experimenter decides how to go on.</source>
        <translation>Ο πειραματιστής αποφασίζει πώς θα συνεχίσετε.</translation>
    </message>
    <message>
        <source>From now on every answer counts.</source>
        <translation>Από εδώ και πέρα μετράει κάθε απάντηση.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::UnblindDialog</name>
    <message>
        <source>Unblind this study?</source>
        <translation>Άρση τυφλότητας της μελέτης;</translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) are still to come. Whoever conducts their runs will no longer be blind.</source>
        <translation>
            <numerusform>Απομένει %n συμμετέχων. Όποιος διεξάγει τις εκτελέσεις του δεν θα είναι πια τυφλός.</numerusform>
            <numerusform>Απομένουν %n συμμετέχοντες. Όποιος διεξάγει τις εκτελέσεις τους δεν θα είναι πια τυφλός.</numerusform>
        </translation>
    </message>
    <message>
        <source>Reason for unblinding</source>
        <translation>Λόγος άρσης της τυφλότητας</translation>
    </message>
    <message>
        <source>Do not name anyone: the reason is stored permanently.</source>
        <translation>Μην αναφέρετε ονόματα: ο λόγος διατηρείται για πάντα.</translation>
    </message>
    <message>
        <source>Unblind</source>
        <translation>Άρση</translation>
    </message>
    <message>
        <source>The study was not unblinded.
%1</source>
        <translation>Η τυφλότητα δεν άρθηκε.
%1</translation>
    </message>
    <message>
        <source>Everybody will then see the names of the conditions. It is recorded who unblinded the study, when and why. This cannot be undone.</source>
        <translation>Όλοι θα βλέπουν πλέον τα ονόματα των συνθηκών. Καταγράφεται ποιος ήρε την τυφλότητα, πότε και γιατί. Δεν αναιρείται.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::VoidSessionDialog</name>
    <message>
        <source>Void a session</source>
        <translation>Ακύρωση συνεδρίας</translation>
    </message>
    <message>
        <source>Void session %1 of %2?</source>
        <translation>Ακύρωση της συνεδρίας %1 (%2);</translation>
    </message>
    <message>
        <source>For example: the device was not calibrated</source>
        <translation>Για παράδειγμα: η συσκευή δεν ήταν βαθμονομημένη</translation>
    </message>
    <message>
        <source>Keep it as it is</source>
        <translation>Να μείνει ως έχει</translation>
    </message>
    <message>
        <source>Void the session</source>
        <translation>Ακύρωση συνεδρίας</translation>
    </message>
    <message>
        <source>Reason (the trainee can read it)</source>
        <translation>Αιτιολογία (τη βλέπει ο/η εκπαιδευόμενος/-η)</translation>
    </message>
    <message>
        <source>Count a session again</source>
        <translation>Επαναφορά ακυρωμένης συνεδρίας</translation>
    </message>
    <message>
        <source>Count session %1 of %2 again?</source>
        <translation>Να μετράει ξανά η συνεδρία %1 (%2);</translation>
    </message>
    <message>
        <source>The session counts as it did before it was voided: for passing its level and in results. Both decisions are kept with it, each with a name, a time and a reason.</source>
        <translation>Η συνεδρία μετράει όπως πριν από την ακύρωσή της: για την επιτυχία στο επίπεδό της και στα αποτελέσματα. Και οι δύο αποφάσεις παραμένουν αποθηκευμένες μαζί της, καθεμία με όνομα, ώρα και αιτιολογία.</translation>
    </message>
    <message>
        <source>For example: another session was meant</source>
        <translation>Για παράδειγμα: εννοούσα άλλη συνεδρία</translation>
    </message>
    <message>
        <source>Leave it void</source>
        <translation>Να μείνει ακυρωμένη</translation>
    </message>
    <message>
        <source>Count it again</source>
        <translation>Να μετράει ξανά</translation>
    </message>
    <message>
        <source>Recording, scores and comments stay and can still be viewed. The session no longer counts for anything: neither for passing a level nor in anybody&apos;s results. Your name and the reason are stored with it. If it was a mistake, the session can be counted again, with a reason of its own.</source>
        <translation>Η καταγραφή, η βαθμολογία και τα σχόλια διατηρούνται και μπορούν ακόμη να προβληθούν. Η συνεδρία δεν μετράει πλέον πουθενά: ούτε για την επιτυχία σε επίπεδο ούτε στα αποτελέσματα. Το όνομά σας και η αιτιολογία αποθηκεύονται μαζί της. Αν έγινε κατά λάθος, η συνεδρία μπορεί να μετρήσει ξανά, με δική της αιτιολογία.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::WithdrawDialog</name>
    <message>
        <source>Withdraw %1</source>
        <translation>Απόσυρση: %1</translation>
    </message>
    <message>
        <source>The participant wants the recordings erased</source>
        <translation>Ο συμμετέχων θέλει να σβηστούν οι καταγραφές</translation>
    </message>
    <message>
        <source>This cannot be undone.</source>
        <translation>Δεν αναιρείται.</translation>
    </message>
    <message>
        <source>The participant was not withdrawn.
%1</source>
        <translation>Ο συμμετέχων δεν αποσύρθηκε.
%1</translation>
    </message>
    <message>
        <source>%1 no longer takes part.</source>
        <translation>%1: δεν συμμετέχει πλέον.</translation>
    </message>
    <message>
        <source>The request is recorded, and administrators are told of it. One of them then erases the recordings (People, Erase a participant).</source>
        <translation>Το αίτημα καταγράφεται και γνωστοποιείται στους διαχειριστές, που διαγράφουν έπειτα τις καταγραφές (Άτομα, Διαγραφή συμμετέχοντα).</translation>
    </message>
    <message>
        <source>Withdraw %1 only if they leave the study for good. If they merely stopped for today, do not withdraw them: an interrupted run is resumed under Run.</source>
        <translation>Αποσύρετε το %1 μόνο αν φεύγει οριστικά από τη μελέτη. Αν απλώς σταμάτησε για σήμερα, μην το κάνετε: μια εκτέλεση που διακόπηκε συνεχίζεται από τη «Διεξαγωγή».</translation>
    </message>
    <message>
        <source>What is kept: everything that was recorded, under the code. Nothing is erased, unless the participant wants it (below).</source>
        <translation>Τι διατηρείται: όλα όσα καταγράφηκαν, με τον κωδικό. Τίποτα δεν διαγράφεται, εκτός αν το ζητήσει το άτομο (παρακάτω).</translation>
    </message>
    <message>
        <source>What no longer counts: this participant&apos;s answers, also those of finished runs. They are left out of group values and comparisons.</source>
        <translation>Τι δεν μετρά πια: οι απαντήσεις αυτού του ατόμου, και των ολοκληρωμένων εκτελέσεων. Δεν περιλαμβάνονται στις τιμές ομάδας και στις συγκρίσεις.</translation>
    </message>
    <message>
        <source>What ends: an open run cannot be resumed, and no other can be started. The place in the order of conditions is free for the next participant.</source>
        <translation>Τι τελειώνει: μια ανοιχτή εκτέλεση δεν μπορεί να συνεχιστεί, και καμία άλλη δεν μπορεί να αρχίσει. Η θέση στη σειρά των συνθηκών ελευθερώνεται για το επόμενο άτομο.</translation>
    </message>
    <message>
        <source>Do not withdraw</source>
        <translation>Χωρίς απόσυρση</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::WorkspaceBox</name>
    <message>
        <source>Hand and workspace</source>
        <translation>Χέρι και χώρος εργασίας</translation>
    </message>
    <message>
        <source>Tool movement per hand movement</source>
        <translation>Κίνηση εργαλείου ανά κίνηση χεριού</translation>
    </message>
    <message>
        <source>Shift to the right</source>
        <translation>Μετατόπιση δεξιά</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Shift away from you</source>
        <translation>Μετατόπιση εμπρός</translation>
    </message>
    <message>
        <source>Shift up</source>
        <translation>Μετατόπιση πάνω</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Δεξί χέρι</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Αριστερό χέρι</translation>
    </message>
    <message>
        <source>Rotation of the device base to the left</source>
        <translation>Στροφή της βάσης της συσκευής προς τα αριστερά</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Tilt of the base away from you</source>
        <translation>Κλίση της βάσης μακριά από εσάς</translation>
    </message>
    <message>
        <source>Tilt of the base to the right</source>
        <translation>Κλίση της βάσης προς τα δεξιά</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatCanvas</name>
    <message>
        <source>Operating field from above and from the side</source>
        <translation>Χειρουργικό πεδίο από πάνω και από το πλάι</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Από πάνω</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Από το πλάι</translation>
    </message>
    <message>
        <source>x (mm)</source>
        <translation>x (mm)</translation>
    </message>
    <message>
        <source>y (mm)</source>
        <translation>y (mm)</translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation>z (mm)</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatComparison</name>
    <message>
        <source>Objects side by side and instrument, from above and from the side</source>
        <translation>Αντικείμενα πλάι πλάι και εργαλείο, από πάνω και από το πλάι</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatFingers</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatHandling</name>
    <message>
        <source>Objects, target and instrument, from above and from the side</source>
        <translation>Αντικείμενα, στόχος και εργαλείο, από πάνω και από το πλάι</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatPalpation</name>
    <message>
        <source>Contour lines every %1 mm</source>
        <translation>Ισοϋψείς ανά %1 mm</translation>
    </message>
    <message>
        <source>Tissue, fingers and findings, from above and from the side</source>
        <translation>Ιστός, δάκτυλα και ευρήματα, από πάνω και από το πλάι</translation>
    </message>
    <message>
        <source>Lines: %1 mm</source>
        <translation>Γραμμές: %1 mm</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatTube</name>
    <message>
        <source>Elastic tube and instruments, from above and from the side</source>
        <translation>Ελαστικός σωλήνας και εργαλεία, από πάνω και από το πλάι</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatUrethra</name>
    <message>
        <source>The endoscope&apos;s picture, and the canal from the side</source>
        <translation>Η εικόνα του ενδοσκοπίου και η ουρήθρα από το πλάι</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::ForceGauge</name>
    <message>
        <source>Force (N)</source>
        <translation>Δύναμη (N)</translation>
    </message>
    <message>
        <source>Tension (N)</source>
        <translation>Τάση (N)</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Σύσφιξη (N)</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::MapLegend</name>
    <message>
        <source>Largest force</source>
        <translation>Μέγιστη δύναμη</translation>
    </message>
    <message>
        <source>Searched</source>
        <translation>Ερευνήθηκε</translation>
    </message>
    <message>
        <source>%1 – %2 N</source>
        <translation>%1 – %2 N</translation>
    </message>
    <message>
        <source>≥ %1 N</source>
        <translation>≥ %1 N</translation>
    </message>
    <message>
        <source>under %1 N</source>
        <translation>κάτω από %1 N</translation>
    </message>
    <message>
        <source>over %1 N</source>
        <translation>πάνω από %1 N</translation>
    </message>
    <message>
        <source>%1 (band)</source>
        <translation>%1 (ζώνη)</translation>
    </message>
    <message>
        <source>not touched</source>
        <translation>χωρίς επαφή</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::NoticePainter</name>
    <message>
        <source>The endoscope&apos;s picture is off at this level.</source>
        <translation>Η εικόνα του ενδοσκοπίου είναι ανενεργή σε αυτό το επίπεδο.</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::Qt3DSceneView</name>
    <message>
        <source>Operating field in three dimensions</source>
        <translation>Χειρουργικό πεδίο σε τρεις διαστάσεις</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::SceneLoader</name>
    <message>
        <source>Shown in 2D: 3D is switched off on this station.</source>
        <translation>Δισδιάστατη προβολή: η τρισδιάστατη είναι απενεργοποιημένη σε αυτόν τον σταθμό.</translation>
    </message>
    <message>
        <source>Shown in 2D: OpenGL is not available here.</source>
        <translation>Δισδιάστατη προβολή: το OpenGL δεν είναι διαθέσιμο εδώ.</translation>
    </message>
    <message>
        <source>Shown in 2D: the 3D part of Chiron is not installed.</source>
        <translation>Δισδιάστατη προβολή: το τρισδιάστατο τμήμα του Chiron δεν είναι εγκατεστημένο.</translation>
    </message>
    <message>
        <source>Shown in 2D: the 3D part of Chiron could not be loaded (%1).</source>
        <translation>Δισδιάστατη προβολή: το τρισδιάστατο τμήμα του Chiron δεν φορτώθηκε (%1).</translation>
    </message>
    <message>
        <source>Shown in 2D: the 3D part belongs to another version of Chiron. Reinstall Chiron to fix this.</source>
        <translation>Δισδιάστατη προβολή: το τρισδιάστατο τμήμα ανήκει σε άλλη έκδοση του Chiron. Εγκαταστήστε ξανά το Chiron.</translation>
    </message>
    <message>
        <source>Shown in 2D: this exercise has no 3D scene.</source>
        <translation>Δισδιάστατη προβολή: αυτή η άσκηση δεν έχει τρισδιάστατη σκηνή.</translation>
    </message>
</context>
<context>
    <name>report</name>
    <message>
        <source>no pass mark</source>
        <translation>χωρίς όριο επιτυχίας</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>όριο επιτυχίας %1</translation>
    </message>
    <message>
        <source>✓ met: %1</source>
        <translation>✓ εντός: %1</translation>
    </message>
    <message>
        <source>✗ not met: %1</source>
        <translation>✗ εκτός: %1</translation>
    </message>
    <message>
        <source>Benchmark %1</source>
        <translation>Τιμή αναφοράς %1</translation>
    </message>
    <message>
        <source>Benchmark %1, %2</source>
        <translation>Τιμή αναφοράς %1, %2</translation>
    </message>
    <message>
        <source>DEMONSTRATION: invented people and results, not for assessment</source>
        <translation>ΕΠΙΔΕΙΞΗ: φανταστικά άτομα και αποτελέσματα, όχι για αξιολόγηση</translation>
    </message>
    <message>
        <source>SIMULATED OPERATOR: a scripted hand, not a person</source>
        <translation>ΠΡΟΣΟΜΟΙΩΜΕΝΟΣ ΧΕΙΡΙΣΤΗΣ: προγραμματισμένο χέρι, όχι άνθρωπος</translation>
    </message>
    <message>
        <source>Unnamed person</source>
        <translation>Άτομο χωρίς όνομα</translation>
    </message>
    <message>
        <source>%1 · level %2: %3</source>
        <translation>%1 · επίπεδο %2: %3</translation>
    </message>
    <message>
        <source>–  No pass mark is set for this level</source>
        <translation>–  Δεν έχει οριστεί όριο επιτυχίας για αυτό το επίπεδο</translation>
    </message>
    <message>
        <source>!  Does not count: %1</source>
        <translation>!  Δεν μετράει: %1</translation>
    </message>
    <message>
        <source>its state is not known</source>
        <translation>η κατάστασή της δεν είναι γνωστή</translation>
    </message>
    <message>
        <source>✓  Passed: every pass mark was met</source>
        <translation>✓  Επιτυχία: επετεύχθησαν όλα τα όρια επιτυχίας</translation>
    </message>
    <message>
        <source>✗  Not passed</source>
        <translation>✗  Αποτυχία</translation>
    </message>
    <message>
        <source>%1 has no value (%2), pass mark %3</source>
        <translation>%1: χωρίς τιμή (%2), όριο επιτυχίας %3</translation>
    </message>
    <message>
        <source>%1: %2, pass mark %3</source>
        <translation>%1: %2, όριο επιτυχίας %3</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Καταγραφή</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Διάρκεια</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Κατάσταση</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Συσκευή</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Δύναμη</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>αισθητή</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>μόνο προβολή</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Συνεδρία</translation>
    </message>
    <message>
        <source>All metrics</source>
        <translation>Όλες οι μετρήσεις</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>δεν ορίζεται</translation>
    </message>
    <message>
        <source>✓ met</source>
        <translation>✓ εντός</translation>
    </message>
    <message>
        <source>✗ not met</source>
        <translation>✗ εκτός</translation>
    </message>
    <message>
        <source>No metrics were computed</source>
        <translation>Δεν υπολογίστηκαν μετρήσεις</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Μέτρηση</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Τιμή</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Όριο επιτυχίας</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Έκβαση</translation>
    </message>
    <message>
        <source>Error in locating the apex</source>
        <translation>Σφάλμα εντοπισμού της κορυφής</translation>
    </message>
    <message>
        <source>The session over time</source>
        <translation>Η συνεδρία στον χρόνο</translation>
    </message>
    <message>
        <source>Where these numbers come from</source>
        <translation>Από πού προέρχονται αυτοί οι αριθμοί</translation>
    </message>
    <message>
        <source>Recorded samples</source>
        <translation>Καταγεγραμμένα δείγματα</translation>
    </message>
    <message>
        <source>Lost samples</source>
        <translation>Χαμένα δείγματα</translation>
    </message>
    <message>
        <source>Stored bytes</source>
        <translation>Αποθηκευμένα byte</translation>
    </message>
    <message>
        <source>Lateness: median, 99th percentile</source>
        <translation>Καθυστέρηση: διάμεσος, 99ο εκατοστημόριο</translation>
    </message>
    <message>
        <source>ran as fast as the computer could</source>
        <translation>έτρεξε με τη μέγιστη ταχύτητα του υπολογιστή</translation>
    </message>
    <message>
        <source>Maximum lateness</source>
        <translation>Μέγιστη καθυστέρηση κύκλου</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Έκδοση προγράμματος</translation>
    </message>
    <message>
        <source>Content (SHA-256)</source>
        <translation>Περιεχόμενο (SHA-256)</translation>
    </message>
    <message>
        <source>Recording (BLAKE2b)</source>
        <translation>Καταγραφή (BLAKE2b)</translation>
    </message>
    <message>
        <source>Score (BLAKE2b)</source>
        <translation>Βαθμολογία (BLAKE2b)</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>stopped by the person</source>
        <translation>τη σταμάτησε το άτομο</translation>
    </message>
    <message>
        <source>interrupted: the program ended during the session</source>
        <translation>διακόπηκε: το πρόγραμμα τερματίστηκε κατά τη συνεδρία</translation>
    </message>
    <message>
        <source>incomplete: samples were lost</source>
        <translation>ελλιπής: χάθηκαν δείγματα</translation>
    </message>
    <message>
        <source>faulted: the device or supervisor stopped it</source>
        <translation>βλάβη: τη σταμάτησε η συσκευή ή ο επόπτης δύναμης</translation>
    </message>
    <message>
        <source>voided by a trainer</source>
        <translation>ακυρώθηκε από εκπαιδευτή/-τρια</translation>
    </message>
    <message>
        <source>Session report</source>
        <translation>Αναφορά συνεδρίας</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Σελίδα %1 από %2</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Επίδειξη</translation>
    </message>
    <message>
        <source>no recording digest</source>
        <translation>χωρίς σύνοψη καταγραφής</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Χρόνος (s)</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>σε παύση</translation>
    </message>
    <message>
        <source>No samples were recorded</source>
        <translation>Δεν καταγράφηκαν δείγματα</translation>
    </message>
    <message>
        <source>Position of the tool tip</source>
        <translation>Θέση της άκρης του εργαλείου</translation>
    </message>
    <message>
        <source>Position (mm)</source>
        <translation>Θέση (mm)</translation>
    </message>
    <message>
        <source>Force on the tool</source>
        <translation>Δύναμη στο εργαλείο</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Δύναμη (N)</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>πάνω από το όριο</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>μετρημένη</translation>
    </message>
    <message>
        <source>tissue (assessed)</source>
        <translation>ιστός (αξιολογείται)</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>όριο %1</translation>
    </message>
    <message>
        <source>Speed of the tool tip</source>
        <translation>Ταχύτητα της άκρης του εργαλείου</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Ταχύτ. (mm/s)</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>ταχύτητα</translation>
    </message>
    <message>
        <source>Where the marks lie on the sphere</source>
        <translation>Πού βρίσκονται τα σημεία στη σφαίρα</translation>
    </message>
    <message>
        <source>Error in x (% of radius)</source>
        <translation>Σφάλμα x (% ακτίνας)</translation>
    </message>
    <message>
        <source>Error in y (% of radius)</source>
        <translation>Σφάλμα y (% ακτίνας)</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>περίγραμμα</translation>
    </message>
    <message>
        <source>mark</source>
        <translation>σημείο</translation>
    </message>
    <message>
        <source>miss</source>
        <translation>αστοχία</translation>
    </message>
    <message>
        <source>no mark: time was up</source>
        <translation>χωρίς σημείο: έληξε ο χρόνος</translation>
    </message>
    <message>
        <source>No trial was marked</source>
        <translation>Δεν σημειώθηκε καμία δοκιμή</translation>
    </message>
    <message>
        <source>Error in locating virtual spheres (%)</source>
        <translation>Σφάλμα εντοπισμού εικονικών σφαιρών (%)</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Δοκιμή</translation>
    </message>
    <message>
        <source>Error (% of radius)</source>
        <translation>Σφάλμα (% ακτίνας)</translation>
    </message>
    <message>
        <source>session</source>
        <translation>συνεδρία</translation>
    </message>
    <message>
        <source>mean ± SD</source>
        <translation>μέσος όρος ± ΤΑ</translation>
    </message>
    <message>
        <source>No sessions to compare</source>
        <translation>Δεν υπάρχουν συνεδρίες για σύγκριση</translation>
    </message>
    <message>
        <source>Off-centre and alignment over depth</source>
        <translation>Απόκλιση από τον άξονα και ευθυγράμμιση ανά βάθος</translation>
    </message>
    <message>
        <source>Landmarks of the bladder seen</source>
        <translation>Οδηγά σημεία της κύστης που φάνηκαν</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 από %2</translation>
    </message>
    <message>
        <source>Distance from the middle of the canal</source>
        <translation>Απόκλιση από τον άξονα της ουρήθρας</translation>
    </message>
    <message>
        <source>Off-centre (mm)</source>
        <translation>Απόκλιση (mm)</translation>
    </message>
    <message>
        <source>off-centre</source>
        <translation>απόκλιση</translation>
    </message>
    <message>
        <source>Angle between endoscope and canal</source>
        <translation>Γωνία ανάμεσα σε ενδοσκόπιο και ουρήθρα</translation>
    </message>
    <message>
        <source>Alignment (°)</source>
        <translation>Ευθυγρ. (°)</translation>
    </message>
    <message>
        <source>alignment</source>
        <translation>ευθυγράμμιση</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Βάθος (mm)</translation>
    </message>
    <message>
        <source>in</source>
        <translation>εισαγωγή</translation>
    </message>
    <message>
        <source>out</source>
        <translation>απόσυρση</translation>
    </message>
    <message>
        <source>bend</source>
        <translation>καμπή</translation>
    </message>
    <message>
        <source>bladder neck</source>
        <translation>αυχένας της κύστης</translation>
    </message>
    <message>
        <source>The endoscope did not enter</source>
        <translation>Το ενδοσκόπιο δεν εισήχθη</translation>
    </message>
    <message>
        <source>Off-centre, largest in each millimetre</source>
        <translation>Απόκλιση από τον άξονα, μέγιστη ανά χιλιοστό</translation>
    </message>
    <message>
        <source>Alignment, largest in each millimetre</source>
        <translation>Ευθυγράμμιση, μέγιστη γωνία ανά χιλιοστό</translation>
    </message>
    <message>
        <source>Largest force at each place</source>
        <translation>Μέγιστη δύναμη σε κάθε θέση</translation>
    </message>
    <message>
        <source>Coverage: %1 % searched</source>
        <translation>Κάλυψη: ερευνήθηκε %1 %</translation>
    </message>
    <message>
        <source>Lumps found: %1 of %2</source>
        <translation>Όζοι που βρέθηκαν: %1 από %2</translation>
    </message>
    <message>
        <source>Findings reported: %1</source>
        <translation>Αναφερθέντα ευρήματα: %1</translation>
    </message>
    <message>
        <source>False alarms: %1</source>
        <translation>Ψευδείς συναγερμοί: %1</translation>
    </message>
    <message>
        <source>not touched</source>
        <translation>χωρίς επαφή</translation>
    </message>
    <message>
        <source>under %1 N: not searched</source>
        <translation>κάτω από %1 N: δεν ερευνήθηκε</translation>
    </message>
    <message>
        <source>%1 N or more: searched</source>
        <translation>%1 N και πάνω: ερευνήθηκε</translation>
    </message>
    <message>
        <source>%1 to %2 N: below the band</source>
        <translation>%1 έως %2 N: κάτω από τη ζώνη</translation>
    </message>
    <message>
        <source>%1 to %2 N: in the band</source>
        <translation>%1 έως %2 N: μέσα στη ζώνη</translation>
    </message>
    <message>
        <source>%1 to %2 N: above the band</source>
        <translation>%1 έως %2 N: πάνω από τη ζώνη</translation>
    </message>
    <message>
        <source>over %1 N: too hard</source>
        <translation>πάνω από %1 N: πολύ δυνατά</translation>
    </message>
    <message>
        <source>lump, found (to scale)</source>
        <translation>όζος, βρέθηκε (υπό κλίμακα)</translation>
    </message>
    <message>
        <source>lump, missed (to scale)</source>
        <translation>όζος, διέφυγε (υπό κλίμακα)</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>εύρημα</translation>
    </message>
    <message>
        <source>finding: hit</source>
        <translation>εύρημα: επιτυχία</translation>
    </message>
    <message>
        <source>finding: false alarm</source>
        <translation>εύρημα: ψευδής συναγερμός</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>near side</source>
        <translation>κοντινή πλευρά</translation>
    </message>
    <message>
        <source>✓ hit</source>
        <translation>✓ επιτυχία</translation>
    </message>
    <message>
        <source>✗ false alarm</source>
        <translation>✗ ψευδής συναγερμός</translation>
    </message>
    <message>
        <source>✗ missed lump</source>
        <translation>✗ όζος που διέφυγε</translation>
    </message>
    <message>
        <source>too few regions: %1 with a lump, %2 without</source>
        <translation>πολύ λίγες περιοχές: %1 με όζο, %2 χωρίς</translation>
    </message>
    <message>
        <source>%1 (95 %: %2 to %3)</source>
        <translation>%1 (95 %: %2 έως %3)</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Τι βρέθηκε</translation>
    </message>
    <message>
        <source>Lumps found</source>
        <translation>Όζοι που βρέθηκαν</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>Ψευδείς συναγερμοί</translation>
    </message>
    <message>
        <source>Regions: hits, false alarms</source>
        <translation>Περιοχές: επιτυχίες, ψευδείς συναγερμοί</translation>
    </message>
    <message>
        <source>%1 of %2, %3 of %4</source>
        <translation>%1 από %2, %3 από %4</translation>
    </message>
    <message>
        <source>Sensitivity d′</source>
        <translation>Ευαισθησία d′</translation>
    </message>
    <message>
        <source>Criterion c</source>
        <translation>Κριτήριο c</translation>
    </message>
    <message>
        <source>Nothing was reported, and nothing was there</source>
        <translation>Δεν αναφέρθηκε τίποτα και δεν υπήρχε τίποτα</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Αρ.</translation>
    </message>
    <message>
        <source>x, y (mm)</source>
        <translation>x, y (mm)</translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation>Ακτίνα (mm)</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Σκληρότητα</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Βεβαιότητα</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Έκβαση</translation>
    </message>
    <message>
        <source>Error (mm)</source>
        <translation>Σφάλμα (mm)</translation>
    </message>
    <message>
        <source>Trial %1, time ran out</source>
        <translation>Δοκιμή %1, έληξε ο χρόνος</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>Δοκιμή %1</translation>
    </message>
    <message>
        <source>No trial was started</source>
        <translation>Δεν άρχισε καμία δοκιμή</translation>
    </message>
    <message>
        <source>✓ done</source>
        <translation>✓ έγινε</translation>
    </message>
    <message>
        <source>✗ time was up</source>
        <translation>✗ έληξε ο χρόνος</translation>
    </message>
    <message>
        <source>✗ torn</source>
        <translation>✗ σχίστηκε</translation>
    </message>
    <message>
        <source>✗ no longer possible</source>
        <translation>✗ δεν ήταν πια δυνατό</translation>
    </message>
    <message>
        <source>not finished</source>
        <translation>δεν τελείωσε</translation>
    </message>
    <message>
        <source>Tension of the tube</source>
        <translation>Τάση του σωλήνα</translation>
    </message>
    <message>
        <source>Tension (N)</source>
        <translation>Τάση (N)</translation>
    </message>
    <message>
        <source>band, from</source>
        <translation>ζώνη, από</translation>
    </message>
    <message>
        <source>band, to</source>
        <translation>ζώνη, έως</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>τάση</translation>
    </message>
    <message>
        <source>How far the tube was stretched</source>
        <translation>Πόσο τεντώθηκε ο σωλήνας</translation>
    </message>
    <message>
        <source>Stretch (mm)</source>
        <translation>Τέντωμα (mm)</translation>
    </message>
    <message>
        <source>mark, from</source>
        <translation>σημάδι, από</translation>
    </message>
    <message>
        <source>mark, to</source>
        <translation>σημάδι, έως</translation>
    </message>
    <message>
        <source>over-stretched</source>
        <translation>υπερτέντωμα</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>τέντωμα</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Στόχος</translation>
    </message>
    <message>
        <source>Tension error</source>
        <translation>Σφάλμα τάσης</translation>
    </message>
    <message>
        <source>In the band</source>
        <translation>Στη ζώνη</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Μέγιστο τέντωμα</translation>
    </message>
    <message>
        <source>Over-stretches</source>
        <translation>Υπερτεντώματα</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Απώλειες λαβής</translation>
    </message>
    <message>
        <source>Largest squeeze of each trial</source>
        <translation>Μέγιστη σύσφιξη κάθε δοκιμής</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Σύσφιξη (N)</translation>
    </message>
    <message>
        <source>squeeze</source>
        <translation>σύσφιξη</translation>
    </message>
    <message>
        <source>Where the objects lay at the end</source>
        <translation>Πού βρίσκονταν τα αντικείμενα στο τέλος</translation>
    </message>
    <message>
        <source>Offset from target, x (mm)</source>
        <translation>Απόσταση στόχου, x (mm)</translation>
    </message>
    <message>
        <source>Offset from target, y (mm)</source>
        <translation>Απόσταση στόχου, y (mm)</translation>
    </message>
    <message>
        <source>target</source>
        <translation>στόχος</translation>
    </message>
    <message>
        <source>set down</source>
        <translation>αποτέθηκε</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>δεν έγινε</translation>
    </message>
    <message>
        <source>Largest squeeze</source>
        <translation>Μέγιστη σύσφιξη</translation>
    </message>
    <message>
        <source>Squeezed too hard</source>
        <translation>Υπερβολική σύσφιξη</translation>
    </message>
    <message>
        <source>Target distance</source>
        <translation>Απόσταση στόχου</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Επιλογή</translation>
    </message>
    <message>
        <source>never held</source>
        <translation>δεν κρατήθηκε</translation>
    </message>
    <message>
        <source>✓ the heaviest</source>
        <translation>✓ το βαρύτερο</translation>
    </message>
    <message>
        <source>✗ a lighter one</source>
        <translation>✗ ένα ελαφρύτερο</translation>
    </message>
    <message>
        <source>rendered to a scripted hand</source>
        <translation>αποδόθηκε σε προγραμματισμένο χέρι</translation>
    </message>
    <message>
        <source>The session was not completed: these values are not compared with pass marks.</source>
        <translation>Η συνεδρία δεν ολοκληρώθηκε: αυτές οι τιμές δεν συγκρίνονται με όρια επιτυχίας.</translation>
    </message>
    <message>
        <source>No trial was completed: there is no score.</source>
        <translation>Δεν ολοκληρώθηκε καμία δοκιμή: δεν υπάρχει βαθμολογία.</translation>
    </message>
    <message>
        <source>Benchmark, chance</source>
        <translation>Αναφορά, τύχη</translation>
    </message>
    <message>
        <source>Tension and stretch</source>
        <translation>Τάση και τέντωμα</translation>
    </message>
    <message>
        <source>Squeeze and place of each trial</source>
        <translation>Σύσφιξη και θέση κάθε δοκιμής</translation>
    </message>
    <message>
        <source>Force of the tissue, and what was felt</source>
        <translation>Δύναμη του ιστού και τι έγινε αισθητό</translation>
    </message>
    <message>
        <source>Ticks: all, late, skipped</source>
        <translation>Κύκλοι: όλοι, καθυστερημένοι, χαμένοι</translation>
    </message>
    <message>
        <source>by chance %1</source>
        <translation>τυχαία %1</translation>
    </message>
    <message>
        <source>The tissue force reached %1. None of it was felt: the force was only shown.</source>
        <translation>Η δύναμη του ιστού έφτασε έως %1. Δεν έγινε αισθητή: μόνο προβλήθηκε.</translation>
    </message>
    <message>
        <source>The tissue force reached %1, and all of it was felt.</source>
        <translation>Η δύναμη του ιστού έφτασε έως %1 και έγινε όλη αισθητή.</translation>
    </message>
    <message>
        <source>The tissue force reached %1, but at most %2 of it was felt: the force was limited for %3, first after %4.</source>
        <translation>Η δύναμη του ιστού έφτασε έως %1, αλλά έγιναν αισθητά το πολύ %2: η δύναμη περιορίστηκε για %3, πρώτη φορά μετά από %4.</translation>
    </message>
    <message>
        <source>%1 of the samples lie deeper or farther out than the range in which the force law was checked. Their force is bounded and counts, but it is less certain than the rest.</source>
        <translation>Το %1 των δειγμάτων βρίσκεται βαθύτερα ή πιο έξω από την περιοχή όπου έχει ελεγχθεί ο νόμος της δύναμης. Η δύναμή τους περιορίζεται και μετρά, αλλά είναι λιγότερο βέβαιη από την υπόλοιπη.</translation>
    </message>
    <message>
        <source>felt (commanded)</source>
        <translation>αισθητή (εντολή)</translation>
    </message>
    <message>
        <source>Nothing was touched.</source>
        <translation>Δεν αγγίχτηκε τίποτα.</translation>
    </message>
    <message>
        <source>Pull on the fold of tissue</source>
        <translation>Έλξη της πτυχής ιστού</translation>
    </message>
    <message>
        <source>Pull (N)</source>
        <translation>Έλξη (N)</translation>
    </message>
    <message>
        <source>pull</source>
        <translation>έλξη</translation>
    </message>
    <message>
        <source>Retraction in the band</source>
        <translation>Έλξη της πτυχής μέσα στη ζώνη</translation>
    </message>
    <message>
        <source>Critical errors</source>
        <translation>Κρίσιμα σφάλματα</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Χρόνος</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Εργαλείο</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Τι συνέβη</translation>
    </message>
    <message>
        <source>critical error</source>
        <translation>κρίσιμο σφάλμα</translation>
    </message>
    <message>
        <source>Position of the tool tips, x</source>
        <translation>Θέση των άκρων των εργαλείων, x</translation>
    </message>
    <message>
        <source>Position of the tool tips, y</source>
        <translation>Θέση των άκρων των εργαλείων, y</translation>
    </message>
    <message>
        <source>Position of the tool tips, z</source>
        <translation>Θέση των άκρων των εργαλείων, z</translation>
    </message>
    <message>
        <source>Force of the tissue on each tool (assessed)</source>
        <translation>Δύναμη του ιστού σε κάθε εργαλείο (αξιολογείται)</translation>
    </message>
    <message>
        <source>Force felt (commanded) on each tool</source>
        <translation>Αισθητή δύναμη (εντολή) σε κάθε εργαλείο</translation>
    </message>
    <message>
        <source>Force measured on each tool</source>
        <translation>Μετρημένη δύναμη σε κάθε εργαλείο</translation>
    </message>
    <message>
        <source>Speed of the tool tips</source>
        <translation>Ταχύτητα των άκρων των εργαλείων</translation>
    </message>
    <message>
        <source>No trial was finished</source>
        <translation>Καμία δοκιμή δεν ολοκληρώθηκε</translation>
    </message>
    <message>
        <source>Content without texts (SHA-256)</source>
        <translation>Περιεχόμενο χωρίς κείμενα (SHA-256)</translation>
    </message>
</context>
</TS>
