<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AccountForm</name>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
</context>
<context>
    <name>AccountWords</name>
    <message>
        <source>There were several wrong attempts, so this account has to rest for a moment. Nothing is lost.</source>
        <translation>Nach mehreren falschen Versuchen ist dieses Konto kurz gesperrt. Es geht nichts verloren.</translation>
    </message>
    <message>
        <source>This account is disabled. What was recorded is kept; an administrator can enable the account again.</source>
        <translation>Dieses Konto ist deaktiviert. Aufgezeichnetes bleibt erhalten; die Administration kann das Konto wieder aktivieren.</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>Lernende Person</translation>
    </message>
    <message>
        <source>Trainer</source>
        <translation>Ausbildende Person</translation>
    </message>
    <message>
        <source>Researcher</source>
        <translation>Forschende Person</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>Administration</translation>
    </message>
    <message>
        <source>Name and password do not belong together. Capital and small letters differ; is Caps Lock on?</source>
        <translation>Name und Passwort passen nicht zusammen. Groß- und Kleinschreibung zählt; ist die Feststelltaste aktiv?</translation>
    </message>
    <message>
        <source>Name and recovery code do not belong together. The code has five groups of five letters and digits.</source>
        <translation>Name und Wiederherstellungscode passen nicht zusammen. Der Code besteht aus fünf Gruppen mit je fünf Buchstaben und Ziffern.</translation>
    </message>
    <message numerus="yes">
        <source>Try again in %n second(s)</source>
        <translation>
            <numerusform>Neuer Versuch in %n Sekunde</numerusform>
            <numerusform>Neuer Versuch in %n Sekunden</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Go to: %1</source>
        <translation>Gehe zu: %1</translation>
    </message>
    <message>
        <source>Colours: light</source>
        <translation>Farben: hell</translation>
    </message>
    <message>
        <source>Colours: dark</source>
        <translation>Farben: dunkel</translation>
    </message>
    <message>
        <source>Colours: high contrast</source>
        <translation>Farben: hoher Kontrast</translation>
    </message>
    <message>
        <source>Larger text and controls</source>
        <translation>Text und Bedienelemente größer</translation>
    </message>
    <message>
        <source>Smaller text and controls</source>
        <translation>Text und Bedienelemente kleiner</translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation>Sprache: %1</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Help for this screen</source>
        <translation>Hilfe zu dieser Ansicht</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Switch user</source>
        <translation>Person wechseln</translation>
    </message>
    <message>
        <source>Close Chiron</source>
        <translation>Chiron beenden</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
</context>
<context>
    <name>ErrorWords</name>
    <message>
        <source>%1
Details: %2</source>
        <translation>%1
Einzelheiten: %2</translation>
    </message>
</context>
<context>
    <name>ForceWords</name>
    <message>
        <source>Force is stopped</source>
        <translation>Kraft ist gestoppt</translation>
    </message>
    <message>
        <source>The clock stands still and everything so far is kept. Press Re-arm (or R) to go on, or End.</source>
        <translation>Die Uhr steht und alles Bisherige bleibt erhalten. Drücken Sie „Freigeben“ (oder R), um weiterzumachen, oder „Beenden“.</translation>
    </message>
    <message>
        <source>The safety supervisor took force away.</source>
        <translation>Die Sicherheitsüberwachung hat die Kraft weggenommen.</translation>
    </message>
    <message>
        <source>The tool moved faster than is safe, so force was taken away.</source>
        <translation>Das Instrument bewegte sich schneller, als sicher ist; deshalb wurde die Kraft weggenommen.</translation>
    </message>
    <message>
        <source>The device&apos;s data came too late, so force was taken away.</source>
        <translation>Die Daten des Geräts kamen zu spät; deshalb wurde die Kraft weggenommen.</translation>
    </message>
    <message>
        <source>The device sent positions that cannot be right, so force was taken away.</source>
        <translation>Das Gerät meldete unmögliche Positionen; deshalb wurde die Kraft weggenommen.</translation>
    </message>
    <message>
        <source>The device reports a fault, so force was taken away.</source>
        <translation>Das Gerät meldet einen Fehler; deshalb wurde die Kraft weggenommen.</translation>
    </message>
    <message>
        <source>The calculated force was not a number, so force was taken away. Please report this.</source>
        <translation>Die berechnete Kraft war keine Zahl; deshalb wurde die Kraft weggenommen. Bitte melden Sie das.</translation>
    </message>
    <message>
        <source>The clock stands still and everything so far is kept. Hold the tool safely, then press Re-arm (or R).</source>
        <translation>Die Uhr steht und alles Bisherige bleibt erhalten. Halten Sie das Instrument sicher und drücken Sie dann „Freigeben“ (oder R).</translation>
    </message>
    <message>
        <source>Waiting for the device</source>
        <translation>Warten auf das Gerät</translation>
    </message>
    <message>
        <source>No usable position has come yet. Check that it is on.</source>
        <translation>Noch keine brauchbare Position empfangen. Prüfen Sie, ob das Gerät eingeschaltet ist.</translation>
    </message>
    <message>
        <source>Hold still</source>
        <translation>Bitte stillhalten</translation>
    </message>
    <message>
        <source>Hold the tool still for half a second; force then rises slowly.</source>
        <translation>Halten Sie das Instrument eine halbe Sekunde still; die Kraft steigt dann langsam an.</translation>
    </message>
    <message>
        <source>Force is held</source>
        <translation>Kraft wird zurückgehalten</translation>
    </message>
    <message>
        <source>The window did not answer for a moment. Force comes back by itself.</source>
        <translation>Das Fenster hat kurz nicht reagiert. Die Kraft kommt von selbst zurück.</translation>
    </message>
    <message>
        <source>Force is waiting</source>
        <translation>Kraft wartet</translation>
    </message>
    <message>
        <source>Move the tool out of contact, or hold it still and press Resume here.</source>
        <translation>Lösen Sie das Instrument vom Kontakt, oder halten Sie es still und drücken Sie „Hier fortsetzen“.</translation>
    </message>
    <message>
        <source>You are watching</source>
        <translation>Sie sehen zu</translation>
    </message>
    <message>
        <source>Force is shown, not felt.</source>
        <translation>Die Kraft wird gezeigt, nicht gefühlt.</translation>
    </message>
    <message>
        <source>No movement</source>
        <translation>Keine Bewegung</translation>
    </message>
    <message>
        <source>Nothing has moved for two seconds. Move the mouse over the scene or press an arrow key.</source>
        <translation>Seit zwei Sekunden bewegt sich nichts. Bewegen Sie die Maus über der Szene oder drücken Sie eine Pfeiltaste.</translation>
    </message>
    <message>
        <source>Shown, not felt</source>
        <translation>Gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>This device renders no force. The tool stays at the surface and moves more slowly the harder you press.</source>
        <translation>Dieses Gerät gibt keine Kraft aus. Das Instrument bleibt an der Oberfläche und bewegt sich umso langsamer, je fester Sie drücken.</translation>
    </message>
    <message>
        <source>Getting ready</source>
        <translation>Vorbereitung</translation>
    </message>
    <message>
        <source>The first trial begins as soon as the scene is drawn.</source>
        <translation>Der erste Durchgang beginnt, sobald die Szene zu sehen ist.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>The clock stands still. Press Resume or Space to go on.</source>
        <translation>Die Uhr steht. Weiter mit „Fortsetzen“ oder der Leertaste.</translation>
    </message>
    <message>
        <source>Force is coming</source>
        <translation>Kraft kommt</translation>
    </message>
    <message>
        <source>It rises slowly; the clock starts at full strength (%1 %).</source>
        <translation>Sie steigt langsam an; die Uhr startet bei voller Stärke (%1 %).</translation>
    </message>
    <message>
        <source>Force is on</source>
        <translation>Kraft ist an</translation>
    </message>
    <message>
        <source>Esc stops it at once.</source>
        <translation>Esc stoppt sie sofort.</translation>
    </message>
    <message>
        <source>The device&apos;s data come late. Force comes back when they are on time.</source>
        <translation>Die Daten des Geräts kommen verspätet. Die Kraft kommt zurück, sobald sie pünktlich sind.</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <translation>Hilfe: %1</translation>
    </message>
    <message>
        <source>Keys on this screen</source>
        <translation>Tasten in dieser Ansicht</translation>
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
        <translation>Suchen in:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>Datei&amp;name:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Dateityp:</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Ordner:</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Übergeordneter Ordner</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Neuen Ordner anlegen</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 ist schon vorhanden.
Möchten Sie die Datei ersetzen?</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Geändert am</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
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
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nein</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Runter</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
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
        <translation>Eingabe</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>Screens</name>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
</context>
<context>
    <name>SoundLoader</name>
    <message>
        <source>Sound is switched off on this station. Everything that can be heard is also shown.</source>
        <translation>Der Ton ist an diesem Arbeitsplatz ausgeschaltet. Alles Hörbare wird auch angezeigt.</translation>
    </message>
    <message>
        <source>The sound part of Chiron is not installed. Everything that can be heard is also shown.</source>
        <translation>Der Tonteil von Chiron ist nicht installiert. Alles Hörbare wird auch angezeigt.</translation>
    </message>
    <message>
        <source>The sound part belongs to another version of Chiron. Everything that can be heard is also shown.</source>
        <translation>Der Tonteil gehört zu einer anderen Version von Chiron. Alles Hörbare wird auch angezeigt.</translation>
    </message>
    <message>
        <source>This station has no sound output. Everything that can be heard is also shown.</source>
        <translation>Dieser Arbeitsplatz hat keine Tonausgabe. Alles Hörbare wird auch angezeigt.</translation>
    </message>
</context>
<context>
    <name>TrainingWords</name>
    <message>
        <source>Expert</source>
        <translation>Erfahren</translation>
    </message>
    <message>
        <source>Intermediate</source>
        <translation>Fortgeschritten</translation>
    </message>
    <message>
        <source>Novice</source>
        <translation>Anfänger/-in</translation>
    </message>
    <message>
        <source>Unsafe (presses too hard)</source>
        <translation>Riskant (drückt zu fest)</translation>
    </message>
    <message>
        <source>Demonstration on the simulated gimbal (%1): shown, not felt</source>
        <translation>Vorführung am simulierten Gimbal (%1): gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Replayed file %1: shown, not felt</source>
        <translation>Abgespielte Datei %1: gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Mouse and keyboard: shown, not felt</source>
        <translation>Maus und Tastatur: gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>You are watching. Space: pause or go on. Esc: stop.</source>
        <translation>Sie sehen zu. Leertaste: Pause oder weiter. Esc: Stopp.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Mark: click or Enter. Space: pause, frees the pointer. Esc: stop force.</source>
        <translation>Bewegen: Maus oder Pfeiltasten. Senken und heben: Mausrad, rechte Taste und ziehen, oder Bild ab und Bild auf. Markieren: Klick oder Enter. Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AdministratorPage</name>
    <message>
        <source>Who looks after this site?</source>
        <translation>Wer betreut diesen Standort?</translation>
    </message>
    <message>
        <source>The first person is an administrator: adds people, makes backups, may train as well.</source>
        <translation>Die erste Person übernimmt die Administration: Sie legt Personen an, erstellt Sicherungen und kann auch selbst trainieren.</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>A short name without commas, such as &quot;ada&quot;. It cannot be changed later.</source>
        <translation>Ein kurzer Name ohne Kommas, zum Beispiel „ada“. Er lässt sich später nicht ändern.</translation>
    </message>
    <message>
        <source>Full name (may be left empty)</source>
        <translation>Vollständiger Name (darf leer bleiben)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Set up the site</source>
        <translation>Standort einrichten</translation>
    </message>
    <message>
        <source>This name cannot be used: no commas, no spaces at the ends, at most %1 characters, and not a name that the program keeps for itself.</source>
        <translation>Dieser Name ist nicht möglich: keine Kommas, keine Leerzeichen am Anfang oder Ende, höchstens %1 Zeichen und kein Name, den das Programm selbst benutzt.</translation>
    </message>
    <message>
        <source>Making the site …</source>
        <translation>Standort wird angelegt …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Type what you want to do</source>
        <translation>Geben Sie ein, was Sie tun möchten</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Gefundene Befehle</translation>
    </message>
    <message>
        <source>No command has these letters. Try fewer, or another word.</source>
        <translation>Kein Befehl enthält diese Buchstaben. Versuchen Sie es mit weniger oder mit einem anderen Wort.</translation>
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
        <translation>Kraft stoppen (Esc)</translation>
    </message>
    <message>
        <source>Resume here</source>
        <translation>Hier fortsetzen</translation>
    </message>
    <message>
        <source>End session …</source>
        <translation>Sitzung beenden …</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pause (Leertaste)</translation>
    </message>
    <message>
        <source>Resume (Space)</source>
        <translation>Fortsetzen (Leertaste)</translation>
    </message>
    <message>
        <source>Re-arm (R)</source>
        <translation>Freigeben (R)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FirstStartScreen</name>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Chiron is a training suite for the sense of touch in minimally invasive surgery.

&quot;Set up this site&quot; makes an empty site on this computer and its first administrator, who can add the others. It takes about a minute.

&quot;Open the demonstration site&quot; makes a separate site with invented people and scripted sessions, to look around. It does not touch a site that is set up later; this choice comes back at the next start until one is.</source>
        <translation>Chiron trainiert den Tastsinn für die minimalinvasive Chirurgie.

„Standort einrichten“ legt auf diesem Computer einen leeren Standort mit der ersten Administration an, die weitere Personen hinzufügen kann. Das dauert etwa eine Minute.

„Demo-Standort öffnen“ legt zum Umsehen einen getrennten Standort mit erfundenen Personen und vorbereiteten Sitzungen an. Ein später eingerichteter Standort bleibt davon unberührt; bis dahin erscheint diese Auswahl bei jedem Start.</translation>
    </message>
    <message>
        <source>The recovery code is not shown again. Write it down and tick the box first.</source>
        <translation>Der Wiederherstellungscode wird nicht noch einmal gezeigt. Schreiben Sie ihn zuerst auf und setzen Sie das Häkchen.</translation>
    </message>
    <message>
        <source>Welcome to Chiron</source>
        <translation>Willkommen bei Chiron</translation>
    </message>
    <message>
        <source>Learn by touch: practise, see what your hand did, and know when you are ready.</source>
        <translation>Lernen durch Tasten: üben, sehen, was Ihre Hand getan hat, und wissen, wann Sie so weit sind.</translation>
    </message>
    <message>
        <source>Set up this site</source>
        <translation>Standort einrichten</translation>
    </message>
    <message>
        <source>Start a site of your own</source>
        <translation>Eigenen Standort anlegen</translation>
    </message>
    <message>
        <source>You become its administrator. People, sessions and scores stay on this computer.</source>
        <translation>Sie übernehmen die Administration. Personen, Sitzungen und Wertungen bleiben auf diesem Computer.</translation>
    </message>
    <message>
        <source>Open the demonstration site</source>
        <translation>Demo-Standort öffnen</translation>
    </message>
    <message>
        <source>Look around first</source>
        <translation>Erst einmal umsehen</translation>
    </message>
    <message>
        <source>Invented people and scripted sessions at every level. Making it takes about a minute, once.</source>
        <translation>Erfundene Personen und vorbereitete Sitzungen auf jeder Stufe. Das Anlegen dauert einmalig etwa eine Minute.</translation>
    </message>
    <message>
        <source>The site was not made.
%1</source>
        <translation>Der Standort wurde nicht angelegt.
%1</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Opening the demonstration site …</source>
        <translation>Demo-Standort wird geöffnet …</translation>
    </message>
    <message>
        <source>Making the demonstration site: people, and scripted sessions at every level …</source>
        <translation>Demo-Standort wird angelegt: Personen und vorbereitete Sitzungen auf jeder Stufe …</translation>
    </message>
    <message>
        <source>The demonstration was stopped; what had been made of it is removed.</source>
        <translation>Die Demo wurde abgebrochen; was davon schon angelegt war, ist entfernt.</translation>
    </message>
    <message>
        <source>The demonstration site could not be opened.</source>
        <translation>Der Demo-Standort konnte nicht geöffnet werden.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ForceBar</name>
    <message>
        <source>over the limit</source>
        <translation>über der Grenze</translation>
    </message>
    <message>
        <source>%1 %2, over the limit</source>
        <translation>%1 %2, über der Grenze</translation>
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
        <translation>%1 · Eingewöhnung, zählt nicht</translation>
    </message>
    <message>
        <source>Sound off</source>
        <translation>Ton aus</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <translation>Durchgang %1 von %2</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>noch %1 s</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Ton an</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::InfoPanel</name>
    <message>
        <source>Elapsed: %1</source>
        <translation>Vergangen: %1</translation>
    </message>
    <message>
        <source>This level shows no measurements: work by what you feel. Everything is recorded and in the results.</source>
        <translation>Diese Stufe zeigt keine Messwerte: Arbeiten Sie nach Gefühl. Alles wird aufgezeichnet und steht im Ergebnis.</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>mN·m</source>
        <translation>mN·m</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>away from you</source>
        <translation>von Ihnen weg</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Geschwindigkeit (mm/s)</translation>
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
            <numerusform>%n Messpunkt konnte nicht aufgezeichnet werden: Diese Sitzung wird unvollständig.</numerusform>
            <numerusform>%n Messpunkte konnten nicht aufgezeichnet werden: Diese Sitzung wird unvollständig.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Recording complete; %n ticks late</source>
        <translation>
            <numerusform>Aufzeichnung vollständig; %n Takt verspätet</numerusform>
            <numerusform>Aufzeichnung vollständig; %n Takte verspätet</numerusform>
        </translation>
    </message>
    <message>
        <source>Recording complete; every tick on time</source>
        <translation>Aufzeichnung vollständig; jeder Takt pünktlich</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LivePlot</name>
    <message>
        <source>The last %1 seconds</source>
        <translation>Die letzten %1 Sekunden</translation>
    </message>
    <message>
        <source>-%1 s</source>
        <translation>-%1 s</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LockController</name>
    <message>
        <source>Locked - Chiron</source>
        <translation>Gesperrt - Chiron</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LockCover</name>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>%1 is logged in. Everything goes on and is kept; it is only covered.</source>
        <translation>%1 ist angemeldet. Alles läuft weiter und bleibt erhalten; es ist nur verdeckt.</translation>
    </message>
    <message>
        <source>Password of %1</source>
        <translation>Passwort von %1</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Switch user</source>
        <translation>Person wechseln</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Wird geprüft …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LoginForm</name>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Forgot your password?</source>
        <translation>Passwort vergessen?</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Wird geprüft …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LoginScreen</name>
    <message>
        <source>Opening the site …</source>
        <translation>Standort wird geöffnet …</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Type a few letters of your name, or choose it in the list, then enter your password.

After three wrong passwords the account rests for a moment before the next attempt; the button counts the seconds. Nothing is lost by it.

Forgot your password? An administrator can give you a new one. The first administrator has a recovery code.</source>
        <translation>Geben Sie einige Buchstaben Ihres Namens ein oder wählen Sie ihn in der Liste, danach Ihr Passwort.

Nach drei falschen Passwörtern ist das Konto kurz gesperrt; die Schaltfläche zählt die Sekunden. Es geht dabei nichts verloren.

Passwort vergessen? Die Administration kann Ihnen ein neues geben. Die erste Administration hat einen Wiederherstellungscode.</translation>
    </message>
    <message>
        <source>The site could not be opened.</source>
        <translation>Der Standort konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>The names could not be read.</source>
        <translation>Die Namen konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>This is a demonstration: choose anybody. The password of all of them is %1</source>
        <translation>Dies ist eine Demo: Wählen Sie eine beliebige Person. Das Passwort ist bei allen %1</translation>
    </message>
    <message>
        <source>This is the password that you were given. Choose another one.</source>
        <translation>Das ist das Passwort, das Sie erhalten haben. Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>The password was not changed.
%1</source>
        <translation>Das Passwort wurde nicht geändert.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::MainWindow</name>
    <message>
        <source>Demonstration site: invented people and scripted sessions. Do not record real training here.</source>
        <translation>Demo-Standort: erfundene Personen und vorbereitete Sitzungen. Zeichnen Sie hier kein echtes Training auf.</translation>
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
        <translation>Meldung schließen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::NameList</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Type your name, or choose it below</source>
        <translation>Name eingeben oder unten auswählen</translation>
    </message>
    <message>
        <source>People who can log in</source>
        <translation>Personen, die sich anmelden können</translation>
    </message>
    <message>
        <source>Nobody of this name can log in here. Ask an administrator to add you.</source>
        <translation>Unter diesem Namen kann sich hier niemand anmelden. Bitten Sie die Administration, Sie hinzuzufügen.</translation>
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
        <translation>Wählen Sie ein eigenes Passwort</translation>
    </message>
    <message>
        <source>Your present password was set by somebody else. From the next login on, only the new one counts.</source>
        <translation>Ihr jetziges Passwort hat jemand anderes festgelegt. Ab der nächsten Anmeldung gilt nur noch das neue.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Save and log in</source>
        <translation>Speichern und anmelden</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Wird gespeichert …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PasswordFields</name>
    <message>
        <source>New password</source>
        <translation>Neues Passwort</translation>
    </message>
    <message>
        <source>The same password again</source>
        <translation>Dasselbe Passwort noch einmal</translation>
    </message>
    <message>
        <source>Show the password</source>
        <translation>Passwort anzeigen</translation>
    </message>
    <message>
        <source>Length: %1 characters or more</source>
        <translation>Länge: mindestens %1 Zeichen</translation>
    </message>
    <message>
        <source>Variety: %1 different characters or more</source>
        <translation>Vielfalt: mindestens %1 verschiedene Zeichen</translation>
    </message>
    <message>
        <source>Not the login name</source>
        <translation>Nicht der Anmeldename</translation>
    </message>
    <message>
        <source>Both fields are the same</source>
        <translation>Beide Felder stimmen überein</translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Erfüllt: %1</translation>
    </message>
    <message>
        <source>Still missing: %1</source>
        <translation>Fehlt noch: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RecoveryCodePanel</name>
    <message>
        <source>Your recovery code</source>
        <translation>Ihr Wiederherstellungscode</translation>
    </message>
    <message>
        <source>With this code you can set a new password if you forget yours. It is shown only now: the program keeps no readable copy, and nobody else can let the first administrator in again. Keep it where you keep keys.</source>
        <translation>Mit diesem Code können Sie ein neues Passwort festlegen, falls Sie Ihres vergessen. Er wird nur jetzt gezeigt: Das Programm bewahrt keine lesbare Kopie auf, und niemand sonst kann der ersten Administration wieder Zugang geben. Bewahren Sie ihn auf wie einen Schlüssel.</translation>
    </message>
    <message>
        <source>Recovery code: %1</source>
        <translation>Wiederherstellungscode: %1</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>I have written the code down</source>
        <translation>Ich habe den Code aufgeschrieben</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Chiron: recovery code of %1

%2

Keep it where you keep keys.</source>
        <translation>Chiron: Wiederherstellungscode von %1

%2

Bewahren Sie ihn auf wie einen Schlüssel.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RecoveryPage</name>
    <message>
        <source>Forgot your password?</source>
        <translation>Passwort vergessen?</translation>
    </message>
    <message>
        <source>Ask an administrator of this site: under People, &quot;Reset password&quot; gives you a new one to log in with. Your sessions and scores are kept.</source>
        <translation>Fragen Sie die Administration dieses Standorts: Unter „Personen“ erhalten Sie mit „Passwort zurücksetzen“ ein neues zum Anmelden. Ihre Sitzungen und Wertungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>The first administrator can use the recovery code that was shown when the site was set up.</source>
        <translation>Die erste Administration kann den Wiederherstellungscode verwenden, der beim Einrichten des Standorts gezeigt wurde.</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Recovery code</source>
        <translation>Wiederherstellungscode</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Set the password</source>
        <translation>Passwort festlegen</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Wird geprüft …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SettingsScreen</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>How the program looks and sounds on this station.

Every choice takes effect at once and is remembered on this computer. Nothing here changes what is recorded or how it is scored.</source>
        <translation>So sieht das Programm an diesem Arbeitsplatz aus, und so klingt es.

Jede Auswahl gilt sofort und bleibt auf diesem Computer gespeichert. Nichts davon ändert, was aufgezeichnet oder wie es gewertet wird.</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Size of text and controls</source>
        <translation>Größe von Text und Bedienelementen</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Play contact and limit sounds while training</source>
        <translation>Beim Training Töne für Kontakt und Grenze abspielen</translation>
    </message>
    <message>
        <source>Everything that can be heard is also shown.</source>
        <translation>Alles Hörbare wird auch angezeigt.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SideBar</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Switch user</source>
        <translation>Person wechseln</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StatePanel</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrainingScreen</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Storing and scoring the session …</source>
        <translation>Sitzung wird gespeichert und gewertet …</translation>
    </message>
    <message>
        <source>The session could not be run</source>
        <translation>Die Sitzung konnte nicht durchgeführt werden</translation>
    </message>
    <message>
        <source>End the session now?</source>
        <translation>Sitzung jetzt beenden?</translation>
    </message>
    <message>
        <source>End the session</source>
        <translation>Sitzung beenden</translation>
    </message>
    <message>
        <source>A session is running. End it and leave?</source>
        <translation>Eine Sitzung läuft. Beenden und verlassen?</translation>
    </message>
    <message>
        <source>End and leave</source>
        <translation>Beenden und verlassen</translation>
    </message>
    <message>
        <source>Preparing the scene …</source>
        <translation>Szene wird vorbereitet …</translation>
    </message>
    <message>
        <source>What is recorded is kept. The session counts as stopped, not as completed.</source>
        <translation>Aufgezeichnetes bleibt erhalten. Die Sitzung gilt als abgebrochen, nicht als abgeschlossen.</translation>
    </message>
    <message>
        <source>Keep training</source>
        <translation>Weiter trainieren</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>Here you work. On the left you see the scene, on the right what is measured, below the controls. A level shows only what belongs to it; what is hidden is still recorded.

%1

Stop force takes force away at once and the clock stands still. Re-arm brings it back slowly. Pause keeps everything as it is.

After the last trial the debrief opens by itself.</source>
        <translation>Hier arbeiten Sie. Links sehen Sie die Szene, rechts die Messwerte, unten die Bedienelemente. Eine Stufe zeigt nur, was zu ihr gehört; Verborgenes wird trotzdem aufgezeichnet.

%1

„Kraft stoppen“ nimmt die Kraft sofort weg, und die Uhr steht. „Freigeben“ bringt sie langsam zurück. „Pause“ lässt alles, wie es ist.

Nach dem letzten Durchgang öffnet sich die Auswertung von selbst.</translation>
    </message>
    <message>
        <source>Stop force</source>
        <translation>Kraft stoppen</translation>
    </message>
    <message>
        <source>Pause or go on</source>
        <translation>Pause oder weiter</translation>
    </message>
    <message>
        <source>Re-arm force</source>
        <translation>Kraft freigeben</translation>
    </message>
    <message>
        <source>Mark this place</source>
        <translation>Diese Stelle markieren</translation>
    </message>
    <message>
        <source>Sound on or off</source>
        <translation>Ton an oder aus</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatCanvas</name>
    <message>
        <source>Operating field from above and from the side</source>
        <translation>Arbeitsfeld von oben und von der Seite</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Von der Seite</translation>
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
        <translation>Kraft (N)</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::Qt3DSceneView</name>
    <message>
        <source>Operating field in three dimensions</source>
        <translation>Arbeitsfeld in drei Dimensionen</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::SceneLoader</name>
    <message>
        <source>Drawn in two dimensions: the 3D part of Chiron is not installed.</source>
        <translation>2D-Darstellung: Der 3D-Teil von Chiron ist nicht installiert.</translation>
    </message>
    <message>
        <source>Drawn in two dimensions: the 3D part of Chiron could not be loaded (%1).</source>
        <translation>2D-Darstellung: Der 3D-Teil von Chiron konnte nicht geladen werden (%1).</translation>
    </message>
    <message>
        <source>Drawn in two dimensions: the 3D part belongs to another version of Chiron. Installing Chiron again repairs this.</source>
        <translation>2D-Darstellung: Der 3D-Teil gehört zu einer anderen Version von Chiron. Installieren Sie Chiron neu, um das zu beheben.</translation>
    </message>
    <message>
        <source>Drawn in two dimensions: 3D is switched off on this station.</source>
        <translation>2D-Darstellung: 3D ist an diesem Arbeitsplatz ausgeschaltet.</translation>
    </message>
    <message>
        <source>Drawn in two dimensions: OpenGL is not available here.</source>
        <translation>2D-Darstellung: OpenGL ist hier nicht verfügbar.</translation>
    </message>
    <message>
        <source>Drawn in two dimensions: this exercise has no 3D scene.</source>
        <translation>2D-Darstellung: Diese Übung hat keine 3D-Szene.</translation>
    </message>
</context>
<context>
    <name>report</name>
    <message>
        <source>no pass mark</source>
        <translation>keine Bestehensgrenze</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>✓ met: %1</source>
        <translation>✓ erreicht: %1</translation>
    </message>
    <message>
        <source>✗ not met: %1</source>
        <translation>✗ nicht erreicht: %1</translation>
    </message>
    <message>
        <source>Benchmark %1</source>
        <translation>Referenz %1</translation>
    </message>
    <message>
        <source>Benchmark %1, %2</source>
        <translation>Referenz %1, %2</translation>
    </message>
    <message>
        <source>DEMONSTRATION: invented people and results, not for assessment</source>
        <translation>DEMO: erfundene Personen und Ergebnisse, nicht zur Beurteilung</translation>
    </message>
    <message>
        <source>SIMULATED OPERATOR: a scripted hand, not a person</source>
        <translation>SIMULIERTE HAND: vom Programm geführt, keine Person</translation>
    </message>
    <message>
        <source>Unnamed person</source>
        <translation>Person ohne Namen</translation>
    </message>
    <message>
        <source>%1 · level %2: %3</source>
        <translation>%1 · Stufe %2: %3</translation>
    </message>
    <message>
        <source>–  No pass mark is set for this level</source>
        <translation>–  Für diese Stufe ist keine Bestehensgrenze festgelegt</translation>
    </message>
    <message>
        <source>!  Does not count: %1</source>
        <translation>!  Zählt nicht: %1</translation>
    </message>
    <message>
        <source>its state is not known</source>
        <translation>ihr Zustand ist nicht bekannt</translation>
    </message>
    <message>
        <source>✓  Passed: every pass mark was met</source>
        <translation>✓  Bestanden: Jede Bestehensgrenze wurde erreicht</translation>
    </message>
    <message>
        <source>✗  Not passed</source>
        <translation>✗  Nicht bestanden</translation>
    </message>
    <message>
        <source>%1 was %2, pass mark %3</source>
        <translation>%1: %2, Bestehensgrenze %3</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>gefühlt</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>All metrics</source>
        <translation>Alle Messgrößen</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>nicht definiert</translation>
    </message>
    <message>
        <source>✓ met</source>
        <translation>✓ erreicht</translation>
    </message>
    <message>
        <source>✗ not met</source>
        <translation>✗ nicht erreicht</translation>
    </message>
    <message>
        <source>No metrics were computed</source>
        <translation>Es wurden keine Messgrößen berechnet</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>Benchmark</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Error in locating the apex</source>
        <translation>Abweichung vom Scheitel</translation>
    </message>
    <message>
        <source>The session over time</source>
        <translation>Die Sitzung im Zeitverlauf</translation>
    </message>
    <message>
        <source>Where these numbers come from</source>
        <translation>Woher diese Zahlen stammen</translation>
    </message>
    <message>
        <source>Recorded frames</source>
        <translation>Aufgezeichnete Messpunkte</translation>
    </message>
    <message>
        <source>Dropped frames</source>
        <translation>Verlorene Messpunkte</translation>
    </message>
    <message>
        <source>Stored bytes</source>
        <translation>Gespeicherte Bytes</translation>
    </message>
    <message>
        <source>Ticks, of them late</source>
        <translation>Takte, davon verspätet</translation>
    </message>
    <message>
        <source>Lateness: median, 99 %</source>
        <translation>Verspätung: Median, 99 %</translation>
    </message>
    <message>
        <source>ran as fast as the machine can</source>
        <translation>lief so schnell wie möglich</translation>
    </message>
    <message>
        <source>Latest tick</source>
        <translation>Größte Verspätung</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Programmstand</translation>
    </message>
    <message>
        <source>Content (SHA-256)</source>
        <translation>Inhalt (SHA-256)</translation>
    </message>
    <message>
        <source>Recording (BLAKE2b)</source>
        <translation>Aufzeichnung (BLAKE2b)</translation>
    </message>
    <message>
        <source>Score (BLAKE2b)</source>
        <translation>Wertung (BLAKE2b)</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>abgeschlossen</translation>
    </message>
    <message>
        <source>stopped by the person</source>
        <translation>von der Person abgebrochen</translation>
    </message>
    <message>
        <source>interrupted: the program ended during the session</source>
        <translation>unterbrochen: Das Programm endete während der Sitzung</translation>
    </message>
    <message>
        <source>incomplete: samples were lost</source>
        <translation>unvollständig: Messpunkte gingen verloren</translation>
    </message>
    <message>
        <source>faulted: the device or supervisor stopped it</source>
        <translation>gestört: von Gerät oder Sicherheitsüberwachung gestoppt</translation>
    </message>
    <message>
        <source>voided by a trainer</source>
        <translation>von einer ausbildenden Person für ungültig erklärt</translation>
    </message>
    <message>
        <source>Session report</source>
        <translation>Sitzungsbericht</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Demo</translation>
    </message>
    <message>
        <source>no recording digest</source>
        <translation>keine Prüfsumme der Aufzeichnung</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>No samples were recorded</source>
        <translation>Es wurden keine Messpunkte aufgezeichnet</translation>
    </message>
    <message>
        <source>Position of the tool tip</source>
        <translation>Position der Instrumentenspitze</translation>
    </message>
    <message>
        <source>Position (mm)</source>
        <translation>Position (mm)</translation>
    </message>
    <message>
        <source>Force on the tool</source>
        <translation>Kraft am Instrument</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>über der Grenze</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>commanded</source>
        <translation>vorgegeben</translation>
    </message>
    <message>
        <source>tissue (assessed)</source>
        <translation>Gewebe (gewertet)</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>Grenze %1</translation>
    </message>
    <message>
        <source>Speed of the tool tip</source>
        <translation>Geschwindigkeit der Instrumentenspitze</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Geschwindigkeit (mm/s)</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Where the marks lie on the sphere</source>
        <translation>Lage der Markierungen auf der Kugel</translation>
    </message>
    <message>
        <source>Error in x (% of radius)</source>
        <translation>Abweichung in x (% des Radius)</translation>
    </message>
    <message>
        <source>Error in y (% of radius)</source>
        <translation>Abweichung in y (% des Radius)</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>mark</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>miss</source>
        <translation>Fehlversuch</translation>
    </message>
    <message>
        <source>No trial was marked</source>
        <translation>Kein Durchgang wurde markiert</translation>
    </message>
    <message>
        <source>% error in locating virtual spheres</source>
        <translation>% Abweichung beim Orten virtueller Kugeln</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>Error (% of radius)</source>
        <translation>Abweichung (% des Radius)</translation>
    </message>
    <message>
        <source>session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>mean ± SD</source>
        <translation>Mittelwert ± SD</translation>
    </message>
    <message>
        <source>No sessions to compare</source>
        <translation>Keine Sitzungen zum Vergleichen</translation>
    </message>
</context>
</TS>
