<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="el" sourcelanguage="en">
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
        <source>There were several wrong attempts, so this account has to rest for a moment. Nothing is lost.</source>
        <translation>Έγιναν αρκετές λανθασμένες προσπάθειες και ο λογαριασμός πρέπει να περιμένει λίγο. Δεν χάνεται τίποτα.</translation>
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
        <source>Name and password do not belong together. Capital and small letters differ; is Caps Lock on?</source>
        <translation>Το όνομα και ο κωδικός πρόσβασης δεν ταιριάζουν. Τα κεφαλαία διαφέρουν από τα πεζά· μήπως είναι ενεργό το Caps Lock;</translation>
    </message>
    <message>
        <source>Name and recovery code do not belong together. The code has five groups of five letters and digits.</source>
        <translation>Το όνομα και ο κωδικός ανάκτησης δεν ταιριάζουν. Ο κωδικός έχει πέντε ομάδες των πέντε γραμμάτων και ψηφίων.</translation>
    </message>
    <message numerus="yes">
        <source>Try again in %n second(s)</source>
        <translation>
            <numerusform>Νέα προσπάθεια σε %n δευτερόλεπτο</numerusform>
            <numerusform>Νέα προσπάθεια σε %n δευτερόλεπτα</numerusform>
        </translation>
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
        <source>Switch user</source>
        <translation>Αλλαγή χρήστη</translation>
    </message>
    <message>
        <source>Close Chiron</source>
        <translation>Κλείσιμο του Chiron</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Οθόνες</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Πρόγραμμα</translation>
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
</context>
<context>
    <name>ForceWords</name>
    <message>
        <source>Force is stopped</source>
        <translation>Η δύναμη σταμάτησε</translation>
    </message>
    <message>
        <source>The clock stands still and everything so far is kept. Press Re-arm (or R) to go on, or End.</source>
        <translation>Ο χρόνος έχει σταματήσει και όλα ως τώρα διατηρούνται. Πατήστε «Ενεργοποίηση» (ή R) για να συνεχίσετε, ή «Τέλος».</translation>
    </message>
    <message>
        <source>The safety supervisor took force away.</source>
        <translation>Ο επόπτης ασφαλείας διέκοψε τη δύναμη.</translation>
    </message>
    <message>
        <source>The tool moved faster than is safe, so force was taken away.</source>
        <translation>Το εργαλείο κινήθηκε ταχύτερα από όσο είναι ασφαλές και η δύναμη διακόπηκε.</translation>
    </message>
    <message>
        <source>The device&apos;s data came too late, so force was taken away.</source>
        <translation>Τα δεδομένα της συσκευής καθυστέρησαν πολύ και η δύναμη διακόπηκε.</translation>
    </message>
    <message>
        <source>The device sent positions that cannot be right, so force was taken away.</source>
        <translation>Η συσκευή έστειλε θέσεις που δεν μπορεί να είναι σωστές και η δύναμη διακόπηκε.</translation>
    </message>
    <message>
        <source>The device reports a fault, so force was taken away.</source>
        <translation>Η συσκευή αναφέρει βλάβη και η δύναμη διακόπηκε.</translation>
    </message>
    <message>
        <source>The calculated force was not a number, so force was taken away. Please report this.</source>
        <translation>Η υπολογισμένη δύναμη δεν ήταν αριθμός και η δύναμη διακόπηκε. Παρακαλούμε αναφέρετέ το.</translation>
    </message>
    <message>
        <source>The clock stands still and everything so far is kept. Hold the tool safely, then press Re-arm (or R).</source>
        <translation>Ο χρόνος έχει σταματήσει και όλα ως τώρα διατηρούνται. Κρατήστε το εργαλείο με ασφάλεια και πατήστε «Ενεργοποίηση» (ή R).</translation>
    </message>
    <message>
        <source>Waiting for the device</source>
        <translation>Αναμονή για τη συσκευή</translation>
    </message>
    <message>
        <source>No usable position has come yet. Check that it is on.</source>
        <translation>Δεν έχει έρθει ακόμη έγκυρη θέση. Ελέγξτε αν είναι ανοιχτή.</translation>
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
        <source>Force is held</source>
        <translation>Η δύναμη συγκρατείται</translation>
    </message>
    <message>
        <source>The window did not answer for a moment. Force comes back by itself.</source>
        <translation>Το παράθυρο δεν ανταποκρίθηκε για λίγο. Η δύναμη επανέρχεται μόνη της.</translation>
    </message>
    <message>
        <source>Force is waiting</source>
        <translation>Η δύναμη περιμένει</translation>
    </message>
    <message>
        <source>Move the tool out of contact, or hold it still and press Resume here.</source>
        <translation>Απομακρύνετε το εργαλείο από την επαφή, ή κρατήστε το ακίνητο και πατήστε «Συνέχεια εδώ».</translation>
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
        <translation>Προβάλλεται, δεν γίνεται αισθητή</translation>
    </message>
    <message>
        <source>This device renders no force. The tool stays at the surface and moves more slowly the harder you press.</source>
        <translation>Αυτή η συσκευή δεν αποδίδει δύναμη. Το εργαλείο μένει στην επιφάνεια και κινείται τόσο πιο αργά όσο πιο δυνατά πιέζετε.</translation>
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
        <source>The clock stands still. Press Resume or Space to go on.</source>
        <translation>Ο χρόνος έχει σταματήσει. Πατήστε «Συνέχεια» ή Διάστημα για να συνεχίσετε.</translation>
    </message>
    <message>
        <source>Force is coming</source>
        <translation>Η δύναμη έρχεται</translation>
    </message>
    <message>
        <source>It rises slowly; the clock starts at full strength (%1 %).</source>
        <translation>Αυξάνεται αργά· ο χρόνος ξεκινά στην πλήρη ένταση (%1 %).</translation>
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
        <source>The device&apos;s data come late. Force comes back when they are on time.</source>
        <translation>Τα δεδομένα της συσκευής καθυστερούν. Η δύναμη επανέρχεται όταν έρχονται εγκαίρως.</translation>
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
        <translation>Return</translation>
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
        <translation>PgUp</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>PgDown</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Del</translation>
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
        <source>Settings</source>
        <translation>Ρυθμίσεις</translation>
    </message>
</context>
<context>
    <name>SoundLoader</name>
    <message>
        <source>Sound is switched off on this station. Everything that can be heard is also shown.</source>
        <translation>Ο ήχος είναι απενεργοποιημένος σε αυτόν τον σταθμό. Ό,τι ακούγεται φαίνεται και στην οθόνη.</translation>
    </message>
    <message>
        <source>The sound part of Chiron is not installed. Everything that can be heard is also shown.</source>
        <translation>Το τμήμα ήχου του Chiron δεν είναι εγκατεστημένο. Ό,τι ακούγεται φαίνεται και στην οθόνη.</translation>
    </message>
    <message>
        <source>The sound part belongs to another version of Chiron. Everything that can be heard is also shown.</source>
        <translation>Το τμήμα ήχου ανήκει σε άλλη έκδοση του Chiron. Ό,τι ακούγεται φαίνεται και στην οθόνη.</translation>
    </message>
    <message>
        <source>This station has no sound output. Everything that can be heard is also shown.</source>
        <translation>Αυτός ο σταθμός δεν έχει έξοδο ήχου. Ό,τι ακούγεται φαίνεται και στην οθόνη.</translation>
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
        <source>Unsafe (presses too hard)</source>
        <translation>Μη ασφαλής (πιέζει υπερβολικά)</translation>
    </message>
    <message>
        <source>Demonstration on the simulated gimbal (%1): shown, not felt</source>
        <translation>Επίδειξη με την προσομοιωμένη καρδανική συσκευή (%1): η δύναμη προβάλλεται, δεν γίνεται αισθητή</translation>
    </message>
    <message>
        <source>Replayed file %1: shown, not felt</source>
        <translation>Αναπαραγωγή αρχείου %1: η δύναμη προβάλλεται, δεν γίνεται αισθητή</translation>
    </message>
    <message>
        <source>Mouse and keyboard: shown, not felt</source>
        <translation>Ποντίκι και πληκτρολόγιο: η δύναμη προβάλλεται, δεν γίνεται αισθητή</translation>
    </message>
    <message>
        <source>You are watching. Space: pause or go on. Esc: stop.</source>
        <translation>Παρακολουθείτε. Διάστημα: παύση ή συνέχεια. Esc: διακοπή.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Mark: click or Enter. Space: pause, frees the pointer. Esc: stop force.</source>
        <translation>Κίνηση: ποντίκι ή βέλη. Κάτω και πάνω: τροχός, δεξί κουμπί με σύρσιμο, ή Page Down και Page Up. Σημείωση: κλικ ή Enter. Διάστημα: παύση, ελευθερώνει τον δείκτη. Esc: διακοπή δύναμης.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AdministratorPage</name>
    <message>
        <source>Who looks after this site?</source>
        <translation>Ποιος φροντίζει αυτό το κέντρο;</translation>
    </message>
    <message>
        <source>The first person is an administrator: adds people, makes backups, may train as well.</source>
        <translation>Το πρώτο άτομο είναι διαχειριστής: προσθέτει άτομα, δημιουργεί αντίγραφα ασφαλείας και μπορεί και να εκπαιδεύεται.</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Όνομα χρήστη</translation>
    </message>
    <message>
        <source>A short name without commas, such as &quot;ada&quot;. It cannot be changed later.</source>
        <translation>Ένα σύντομο όνομα χωρίς κόμματα, π.χ. «eleni». Δεν αλλάζει αργότερα.</translation>
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
        <source>This name cannot be used: no commas, no spaces at the ends, at most %1 characters, and not a name that the program keeps for itself.</source>
        <translation>Αυτό το όνομα δεν επιτρέπεται: χωρίς κόμματα, χωρίς κενά στα άκρα, το πολύ %1 χαρακτήρες και όχι όνομα που κρατά το πρόγραμμα για δική του χρήση.</translation>
    </message>
    <message>
        <source>Making the site …</source>
        <translation>Δημιουργία του κέντρου …</translation>
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
        <source>Type what you want to do</source>
        <translation>Πληκτρολογήστε τι θέλετε να κάνετε</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Εντολές που βρέθηκαν</translation>
    </message>
    <message>
        <source>No command has these letters. Try fewer, or another word.</source>
        <translation>Καμία εντολή δεν έχει αυτά τα γράμματα. Δοκιμάστε λιγότερα ή άλλη λέξη.</translation>
    </message>
    <message>
        <source>%1   (%2)</source>
        <translation>%1   (%2)</translation>
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
</context>
<context>
    <name>chiron::desktop::FirstStartScreen</name>
    <message>
        <source>Welcome</source>
        <translation>Καλωσορίσατε</translation>
    </message>
    <message>
        <source>Chiron is a training suite for the sense of touch in minimally invasive surgery.

&quot;Set up this site&quot; makes an empty site on this computer and its first administrator, who can add the others. It takes about a minute.

&quot;Open the demonstration site&quot; makes a separate site with invented people and scripted sessions, to look around. It does not touch a site that is set up later; this choice comes back at the next start until one is.</source>
        <translation>Το Chiron είναι ένα σύστημα εκπαίδευσης της αίσθησης της αφής στην ελάχιστα επεμβατική χειρουργική.

Η «Δημιουργία κέντρου» φτιάχνει ένα κενό κέντρο σε αυτόν τον υπολογιστή και τον πρώτο διαχειριστή του, που μπορεί να προσθέσει τους υπόλοιπους. Διαρκεί περίπου ένα λεπτό.

Το «Άνοιγμα κέντρου επίδειξης» φτιάχνει ένα ξεχωριστό κέντρο με επινοημένα άτομα και προγραμματισμένες συνεδρίες, για να δείτε το πρόγραμμα. Δεν επηρεάζει κέντρο που θα δημιουργηθεί αργότερα· η επιλογή αυτή εμφανίζεται σε κάθε εκκίνηση μέχρι τότε.</translation>
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
        <source>Start a site of your own</source>
        <translation>Ξεκινήστε το δικό σας κέντρο</translation>
    </message>
    <message>
        <source>You become its administrator. People, sessions and scores stay on this computer.</source>
        <translation>Γίνεστε διαχειριστής του. Τα άτομα, οι συνεδρίες και οι βαθμολογίες μένουν σε αυτόν τον υπολογιστή.</translation>
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
        <source>Invented people and scripted sessions at every level. Making it takes about a minute, once.</source>
        <translation>Επινοημένα άτομα και προγραμματισμένες συνεδρίες σε κάθε επίπεδο. Η δημιουργία διαρκεί περίπου ένα λεπτό, μία φορά.</translation>
    </message>
    <message>
        <source>The site was not made.
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
        <source>Making the demonstration site: people, and scripted sessions at every level …</source>
        <translation>Δημιουργία του κέντρου επίδειξης: άτομα και προγραμματισμένες συνεδρίες σε κάθε επίπεδο …</translation>
    </message>
    <message>
        <source>The demonstration was stopped; what had been made of it is removed.</source>
        <translation>Η επίδειξη σταμάτησε· ό,τι είχε δημιουργηθεί αφαιρέθηκε.</translation>
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
        <translation>απομένουν %1 s</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Ενεργοποίηση ήχου</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::InfoPanel</name>
    <message>
        <source>Elapsed: %1</source>
        <translation>Διάρκεια: %1</translation>
    </message>
    <message>
        <source>This level shows no measurements: work by what you feel. Everything is recorded and in the results.</source>
        <translation>Αυτό το επίπεδο δεν δείχνει μετρήσεις: εργαστείτε με την αφή. Όλα καταγράφονται και υπάρχουν στα αποτελέσματα.</translation>
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
        <source>Tip</source>
        <translation>Άκρη</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>δεξιά</translation>
    </message>
    <message>
        <source>away from you</source>
        <translation>εμπρός</translation>
    </message>
    <message>
        <source>up</source>
        <translation>πάνω</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>ταχύτητα</translation>
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
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 mm/s</source>
        <translation>%1 mm/s</translation>
    </message>
    <message numerus="yes">
        <source>%n samples could not be recorded: this session will be incomplete.</source>
        <translation>
            <numerusform>%n δείγμα δεν καταγράφηκε: αυτή η συνεδρία θα είναι ελλιπής.</numerusform>
            <numerusform>%n δείγματα δεν καταγράφηκαν: αυτή η συνεδρία θα είναι ελλιπής.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Recording complete; %n ticks late</source>
        <translation>
            <numerusform>Πλήρης καταγραφή· καθυστέρησε %n κύκλος</numerusform>
            <numerusform>Πλήρης καταγραφή· καθυστέρησαν %n κύκλοι</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording complete; every tick on time</source>
        <translation>Πλήρης καταγραφή· κανένας κύκλος με καθυστέρηση</translation>
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
        <source>%1 is logged in. Everything goes on and is kept; it is only covered.</source>
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
        <source>Type a few letters of your name, or choose it in the list, then enter your password.

After three wrong passwords the account rests for a moment before the next attempt; the button counts the seconds. Nothing is lost by it.

Forgot your password? An administrator can give you a new one. The first administrator has a recovery code.</source>
        <translation>Πληκτρολογήστε μερικά γράμματα του ονόματός σας ή επιλέξτε το στη λίστα και δώστε τον κωδικό πρόσβασης.

Μετά από τρεις λανθασμένους κωδικούς ο λογαριασμός περιμένει λίγο πριν από την επόμενη προσπάθεια· το κουμπί μετρά τα δευτερόλεπτα. Δεν χάνεται τίποτα.

Ξεχάσατε τον κωδικό; Ένας διαχειριστής μπορεί να σας δώσει νέο. Ο πρώτος διαχειριστής έχει κωδικό ανάκτησης.</translation>
    </message>
    <message>
        <source>The site could not be opened.</source>
        <translation>Το κέντρο δεν ήταν δυνατό να ανοίξει.</translation>
    </message>
    <message>
        <source>The names could not be read.</source>
        <translation>Δεν ήταν δυνατή η ανάγνωση των ονομάτων.</translation>
    </message>
    <message>
        <source>This is a demonstration: choose anybody. The password of all of them is %1</source>
        <translation>Αυτή είναι επίδειξη: επιλέξτε οποιονδήποτε. Ο κωδικός πρόσβασης όλων είναι %1</translation>
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
</context>
<context>
    <name>chiron::desktop::MainWindow</name>
    <message>
        <source>Demonstration site: invented people and scripted sessions. Do not record real training here.</source>
        <translation>Κέντρο επίδειξης: επινοημένα άτομα και προγραμματισμένες συνεδρίες. Μην καταγράφετε εδώ πραγματική εκπαίδευση.</translation>
    </message>
    <message>
        <source>%1 - Chiron</source>
        <translation>%1 - Chiron</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Κλείσιμο του μηνύματος</translation>
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
        <source>Nobody of this name can log in here. Ask an administrator to add you.</source>
        <translation>Κανείς με αυτό το όνομα δεν μπορεί να συνδεθεί εδώ. Ζητήστε από έναν διαχειριστή να σας προσθέσει.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::NewPasswordPage</name>
    <message>
        <source>Choose a password of your own</source>
        <translation>Επιλέξτε δικό σας κωδικό πρόσβασης</translation>
    </message>
    <message>
        <source>Your present password was set by somebody else. From the next login on, only the new one counts.</source>
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
    <name>chiron::desktop::PasswordFields</name>
    <message>
        <source>New password</source>
        <translation>Νέος κωδικός πρόσβασης</translation>
    </message>
    <message>
        <source>The same password again</source>
        <translation>Ο ίδιος κωδικός ξανά</translation>
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
    <name>chiron::desktop::RecoveryCodePanel</name>
    <message>
        <source>Your recovery code</source>
        <translation>Ο κωδικός ανάκτησής σας</translation>
    </message>
    <message>
        <source>With this code you can set a new password if you forget yours. It is shown only now: the program keeps no readable copy, and nobody else can let the first administrator in again. Keep it where you keep keys.</source>
        <translation>Με αυτόν ορίζετε νέο κωδικό πρόσβασης αν ξεχάσετε τον δικό σας. Εμφανίζεται μόνο τώρα: το πρόγραμμα δεν κρατά αναγνώσιμο αντίγραφο και κανείς άλλος δεν μπορεί να ξαναδώσει πρόσβαση στον πρώτο διαχειριστή. Φυλάξτε τον εκεί όπου φυλάτε κλειδιά.</translation>
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

Keep it where you keep keys.</source>
        <translation>Chiron: κωδικός ανάκτησης για %1

%2

Φυλάξτε τον εκεί όπου φυλάτε κλειδιά.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RecoveryPage</name>
    <message>
        <source>Forgot your password?</source>
        <translation>Ξεχάσατε τον κωδικό;</translation>
    </message>
    <message>
        <source>Ask an administrator of this site: under People, &quot;Reset password&quot; gives you a new one to log in with. Your sessions and scores are kept.</source>
        <translation>Απευθυνθείτε σε διαχειριστή του κέντρου: στα «Άτομα», η «Επαναφορά κωδικού» σας δίνει νέο για να συνδεθείτε. Οι συνεδρίες και οι βαθμολογίες σας διατηρούνται.</translation>
    </message>
    <message>
        <source>The first administrator can use the recovery code that was shown when the site was set up.</source>
        <translation>Ο πρώτος διαχειριστής μπορεί να χρησιμοποιήσει τον κωδικό ανάκτησης που εμφανίστηκε κατά τη δημιουργία του κέντρου.</translation>
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
</context>
<context>
    <name>chiron::desktop::SettingsScreen</name>
    <message>
        <source>Settings</source>
        <translation>Ρυθμίσεις</translation>
    </message>
    <message>
        <source>How the program looks and sounds on this station.

Every choice takes effect at once and is remembered on this computer. Nothing here changes what is recorded or how it is scored.</source>
        <translation>Η εμφάνιση και ο ήχος του προγράμματος σε αυτόν τον σταθμό.

Κάθε επιλογή ισχύει αμέσως και μένει σε αυτόν τον υπολογιστή. Τίποτα εδώ δεν αλλάζει όσα καταγράφονται ή τη βαθμολόγησή τους.</translation>
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
        <source>Play contact and limit sounds while training</source>
        <translation>Ήχοι επαφής και ορίου στην εκπαίδευση</translation>
    </message>
    <message>
        <source>Everything that can be heard is also shown.</source>
        <translation>Ό,τι ακούγεται φαίνεται και στην οθόνη.</translation>
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
        <source>Switch user</source>
        <translation>Αλλαγή χρήστη</translation>
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
        <translation>Τέλος της συνεδρίας τώρα;</translation>
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
        <source>Here you work. On the left you see the scene, on the right what is measured, below the controls. A level shows only what belongs to it; what is hidden is still recorded.

%1

Stop force takes force away at once and the clock stands still. Re-arm brings it back slowly. Pause keeps everything as it is.

After the last trial the debrief opens by itself.</source>
        <translation>Εδώ εργάζεστε. Αριστερά βλέπετε τη σκηνή, δεξιά όσα μετρώνται, κάτω τα κουμπιά. Κάθε επίπεδο δείχνει μόνο όσα του ανήκουν· όσα κρύβονται καταγράφονται και αυτά.

%1

Η «Διακοπή δύναμης» αφαιρεί αμέσως τη δύναμη και ο χρόνος σταματά. Η «Ενεργοποίηση» την επαναφέρει αργά. Η «Παύση» κρατά τα πάντα όπως είναι.

Μετά την τελευταία δοκιμή ο απολογισμός ανοίγει μόνος του.</translation>
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
        <translation>Ήχος ναι ή όχι</translation>
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
    <name>chiron::scene3d::ForceGauge</name>
    <message>
        <source>Force (N)</source>
        <translation>Δύναμη (N)</translation>
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
        <source>Drawn in two dimensions: the 3D part of Chiron is not installed.</source>
        <translation>Δισδιάστατη προβολή: το τρισδιάστατο τμήμα του Chiron δεν είναι εγκατεστημένο.</translation>
    </message>
    <message>
        <source>Drawn in two dimensions: the 3D part of Chiron could not be loaded (%1).</source>
        <translation>Δισδιάστατη προβολή: το τρισδιάστατο τμήμα του Chiron δεν φορτώθηκε (%1).</translation>
    </message>
    <message>
        <source>Drawn in two dimensions: the 3D part belongs to another version of Chiron. Installing Chiron again repairs this.</source>
        <translation>Δισδιάστατη προβολή: το τρισδιάστατο τμήμα ανήκει σε άλλη έκδοση του Chiron. Η εκ νέου εγκατάσταση του Chiron το διορθώνει.</translation>
    </message>
    <message>
        <source>Drawn in two dimensions: 3D is switched off on this station.</source>
        <translation>Δισδιάστατη προβολή: η τρισδιάστατη είναι απενεργοποιημένη σε αυτόν τον σταθμό.</translation>
    </message>
    <message>
        <source>Drawn in two dimensions: OpenGL is not available here.</source>
        <translation>Δισδιάστατη προβολή: το OpenGL δεν είναι διαθέσιμο εδώ.</translation>
    </message>
    <message>
        <source>Drawn in two dimensions: this exercise has no 3D scene.</source>
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
        <translation>✓ επετεύχθη: %1</translation>
    </message>
    <message>
        <source>✗ not met: %1</source>
        <translation>✗ δεν επετεύχθη: %1</translation>
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
        <translation>ΕΠΙΔΕΙΞΗ: επινοημένα άτομα και αποτελέσματα, όχι για αξιολόγηση</translation>
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
        <source>%1 was %2, pass mark %3</source>
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
        <translation>γίνεται αισθητή</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>προβάλλεται, δεν γίνεται αισθητή</translation>
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
        <translation>✓ επετεύχθη</translation>
    </message>
    <message>
        <source>✗ not met</source>
        <translation>✗ δεν επετεύχθη</translation>
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
        <source>Benchmark</source>
        <translation>Τιμή αναφοράς</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Αποτέλεσμα</translation>
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
        <source>Recorded frames</source>
        <translation>Καταγεγραμμένα πλαίσια</translation>
    </message>
    <message>
        <source>Dropped frames</source>
        <translation>Χαμένα πλαίσια</translation>
    </message>
    <message>
        <source>Stored bytes</source>
        <translation>Αποθηκευμένα byte</translation>
    </message>
    <message>
        <source>Ticks, of them late</source>
        <translation>Κύκλοι, από αυτούς με καθυστέρηση</translation>
    </message>
    <message>
        <source>Lateness: median, 99 %</source>
        <translation>Καθυστέρηση: διάμεσος, 99 %</translation>
    </message>
    <message>
        <source>ran as fast as the machine can</source>
        <translation>έτρεξε με τη μέγιστη ταχύτητα του υπολογιστή</translation>
    </message>
    <message>
        <source>Latest tick</source>
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
        <translation>βλάβη: τη σταμάτησε η συσκευή ή ο επόπτης ασφαλείας</translation>
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
        <source>commanded</source>
        <translation>εντολή</translation>
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
        <translation>Ταχύτητα (mm/s)</translation>
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
        <translation>Σφάλμα σε x (% της ακτίνας)</translation>
    </message>
    <message>
        <source>Error in y (% of radius)</source>
        <translation>Σφάλμα σε y (% της ακτίνας)</translation>
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
        <source>No trial was marked</source>
        <translation>Δεν σημειώθηκε καμία δοκιμή</translation>
    </message>
    <message>
        <source>% error in locating virtual spheres</source>
        <translation>% σφάλμα εντοπισμού εικονικών σφαιρών</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Δοκιμή</translation>
    </message>
    <message>
        <source>Error (% of radius)</source>
        <translation>Σφάλμα (% της ακτίνας)</translation>
    </message>
    <message>
        <source>session</source>
        <translation>συνεδρία</translation>
    </message>
    <message>
        <source>mean ± SD</source>
        <translation>μέσος όρος ± SD</translation>
    </message>
    <message>
        <source>No sessions to compare</source>
        <translation>Δεν υπάρχουν συνεδρίες για σύγκριση</translation>
    </message>
</context>
</TS>
