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
    <message>
        <source>Your account does not permit this. Ask an administrator if it should.</source>
        <translation>Ihr Konto erlaubt das nicht. Fragen Sie die Administration, falls es das sollte.</translation>
    </message>
    <message>
        <source>It is no longer there, or was never made. Nothing was changed.</source>
        <translation>Es ist nicht mehr da oder wurde nie angelegt. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The storage refused it. What was recorded before is kept; check the free space and try again.</source>
        <translation>Der Speicher hat es nicht angenommen. Was bisher aufgezeichnet wurde, bleibt erhalten; prüfen Sie den freien Platz und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Another program is using this database for writing. Close it there, then try again.</source>
        <translation>Ein anderes Programm schreibt in diese Datenbank. Schließen Sie sie dort und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The device did not answer as it should. Check its cable and power, then try again.</source>
        <translation>Das Gerät hat nicht geantwortet, wie es sollte. Prüfen Sie Kabel und Stromversorgung und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>It was stopped before the end. Nothing was changed.</source>
        <translation>Es wurde vor dem Ende angehalten. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>What was checked does not hold.</source>
        <translation>Die Prüfung ist nicht bestanden.</translation>
    </message>
    <message>
        <source>Something in what was given is not as expected. Nothing was changed.</source>
        <translation>Etwas an den Angaben ist nicht wie erwartet. Nichts wurde geändert.</translation>
    </message>
</context>
<context>
    <name>ExercisePart</name>
    <message>
        <source>The answers, seen from above</source>
        <translation>Die Antworten, von oben gesehen</translation>
    </message>
    <message>
        <source>How the endoscope kept to the urethra</source>
        <translation>Wie das Endoskop der Harnröhre folgte</translation>
    </message>
    <message>
        <source>How the tube was held and stretched</source>
        <translation>Wie der Schlauch gehalten und gedehnt wurde</translation>
    </message>
    <message>
        <source>How each object was held and set down</source>
        <translation>Wie jedes Objekt gehalten und abgelegt wurde</translation>
    </message>
    <message>
        <source>What was searched and what was found</source>
        <translation>Was abgetastet und was gefunden wurde</translation>
    </message>
    <message>
        <source>What was compared</source>
        <translation>Was verglichen wurde</translation>
    </message>
    <message>
        <source>There is no answer to show. The session is kept and listed.</source>
        <translation>Es gibt keine Antwort zu zeigen. Die Sitzung bleibt erhalten und in der Liste.</translation>
    </message>
    <message>
        <source>There is nothing to show of the procedure. The session is kept and listed.</source>
        <translation>Vom Eingriff gibt es nichts zu zeigen. Die Sitzung bleibt erhalten und in der Liste.</translation>
    </message>
    <message>
        <source>There is no tension to show. The session is kept and listed.</source>
        <translation>Es gibt keine Spannung zu zeigen. Die Sitzung bleibt erhalten und in der Liste.</translation>
    </message>
    <message>
        <source>There is no object to show. The session is kept and listed.</source>
        <translation>Es gibt kein Objekt zu zeigen. Die Sitzung bleibt erhalten und in der Liste.</translation>
    </message>
    <message>
        <source>There is no search to show. The session is kept and listed.</source>
        <translation>Es gibt keine Suche zu zeigen. Die Sitzung bleibt erhalten und in der Liste.</translation>
    </message>
    <message>
        <source>What was compared and answered is shown with its study.</source>
        <translation>Was verglichen und geantwortet wurde, steht bei der Studie.</translation>
    </message>
    <message>
        <source>What each trial came to</source>
        <translation>Was jeder Durchgang ergab</translation>
    </message>
    <message>
        <source>%1 of %2 landmarks of the bladder were seen.</source>
        <translation>%1 von %2 Landmarken der Blase wurden gesehen.</translation>
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
        <translation>Die Uhr steht und alles Bisherige bleibt erhalten. Drücken Sie „Freigeben“ (oder R), um weiterzumachen, oder „Sitzung beenden“.</translation>
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
        <translation>Die Uhr steht. Weiter mit der Schaltfläche „Weiter“ oder der Leertaste.</translation>
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
    <message>
        <source>The operator&apos;s force waits until the tool is free.</source>
        <translation>Die Kraft der programmierten Hand wartet, bis das Instrument frei ist.</translation>
    </message>
    <message>
        <source>The operator&apos;s force rises slowly (%1 %).</source>
        <translation>Die Kraft der programmierten Hand steigt langsam an (%1 %).</translation>
    </message>
    <message>
        <source>The operator&apos;s force is held for a moment and comes back by itself.</source>
        <translation>Die Kraft der programmierten Hand wird kurz zurückgehalten und kommt von selbst zurück.</translation>
    </message>
    <message>
        <source>This device renders no force. The endoscope moves more slowly the harder you press.</source>
        <translation>Dieses Gerät gibt keine Kraft aus. Das Endoskop bewegt sich umso langsamer, je fester Sie drücken.</translation>
    </message>
    <message>
        <source>The procedure begins as soon as the scene is drawn.</source>
        <translation>Der Eingriff beginnt, sobald die Szene zu sehen ist.</translation>
    </message>
    <message>
        <source>This device renders no force. An instrument moves more slowly the harder something pulls or presses.</source>
        <translation>Dieses Gerät gibt keine Kraft aus. Ein Instrument bewegt sich umso langsamer, je stärker etwas zieht oder drückt.</translation>
    </message>
</context>
<context>
    <name>GateWords</name>
    <message>
        <source>%1 % of the radius</source>
        <translation>%1 % des Radius</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1: von %2 bis %3</translation>
    </message>
    <message>
        <source>%1: at least %2</source>
        <translation>%1: mindestens %2</translation>
    </message>
    <message>
        <source>%1: at most %2</source>
        <translation>%1: höchstens %2</translation>
    </message>
</context>
<context>
    <name>GraspWords</name>
    <message>
        <source>Take hold of both ends of the tube, one with each instrument</source>
        <translation>Beide Enden des Schlauchs fassen, mit jedem Instrument eines</translation>
    </message>
    <message>
        <source>Take hold of the end of the tube with the right instrument</source>
        <translation>Das Ende des Schlauchs mit dem rechten Instrument fassen</translation>
    </message>
    <message>
        <source>Take hold of the end of the tube</source>
        <translation>Das Ende des Schlauchs fassen</translation>
    </message>
    <message>
        <source>At the mark: hold it there</source>
        <translation>An der Marke: dort halten</translation>
    </message>
    <message>
        <source>At the target: hold it there</source>
        <translation>Am Ziel: dort halten</translation>
    </message>
    <message>
        <source>In the band: keep the tension there</source>
        <translation>Im Bereich: die Spannung dort halten</translation>
    </message>
    <message>
        <source>The tube is torn: this trial is over</source>
        <translation>Der Schlauch ist gerissen: Dieser Durchgang ist zu Ende</translation>
    </message>
    <message>
        <source>Stretch the tube to the mark, and no farther</source>
        <translation>Den Schlauch bis zur Marke dehnen, nicht weiter</translation>
    </message>
    <message>
        <source>Pull until the tension is in its band</source>
        <translation>Ziehen, bis die Spannung in ihrem Bereich ist</translation>
    </message>
    <message>
        <source>Take the tube over with the left instrument, then let go with the right one</source>
        <translation>Den Schlauch mit dem linken Instrument übernehmen, dann mit dem rechten loslassen</translation>
    </message>
    <message>
        <source>Lift the end of the tube</source>
        <translation>Das Ende des Schlauchs anheben</translation>
    </message>
    <message>
        <source>Bring the end of the tube to the target</source>
        <translation>Das Ende des Schlauchs zum Ziel bringen</translation>
    </message>
    <message>
        <source>Let go of the end of the tube</source>
        <translation>Das Ende des Schlauchs loslassen</translation>
    </message>
    <message>
        <source>Done: the next tube follows</source>
        <translation>Fertig: Der nächste Schlauch folgt</translation>
    </message>
    <message>
        <source>Wait for the tube</source>
        <translation>Auf den Schlauch warten</translation>
    </message>
    <message>
        <source>Lift one object after the other and find the heaviest</source>
        <translation>Ein Objekt nach dem anderen anheben und das schwerste finden</translation>
    </message>
    <message>
        <source>Take hold of the object, softly</source>
        <translation>Das Objekt fassen, behutsam</translation>
    </message>
    <message>
        <source>Lift it up</source>
        <translation>Anheben</translation>
    </message>
    <message>
        <source>Is it the heaviest? Bring it over the dish; otherwise set it down</source>
        <translation>Ist es das schwerste? Über die Schale bringen; sonst ablegen</translation>
    </message>
    <message>
        <source>Bring it over the dish</source>
        <translation>Über die Schale bringen</translation>
    </message>
    <message>
        <source>Set it down in the dish and let go</source>
        <translation>In die Schale legen und loslassen</translation>
    </message>
    <message>
        <source>In the dish: leave it at rest</source>
        <translation>In der Schale: in Ruhe lassen</translation>
    </message>
    <message>
        <source>Done: the next one follows</source>
        <translation>Fertig: Das nächste folgt</translation>
    </message>
    <message>
        <source>Wait for the object</source>
        <translation>Auf das Objekt warten</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>Right instrument</source>
        <translation>Rechtes Instrument</translation>
    </message>
    <message>
        <source>Left instrument</source>
        <translation>Linkes Instrument</translation>
    </message>
    <message>
        <source>Instrument %1</source>
        <translation>Instrument %1</translation>
    </message>
    <message>
        <source>Holding: object %1 of %2</source>
        <translation>Gehalten: Objekt %1 von %2</translation>
    </message>
    <message>
        <source>Holding: the object</source>
        <translation>Gehalten: das Objekt</translation>
    </message>
    <message>
        <source>Holding: two places</source>
        <translation>Gehalten: zwei Stellen</translation>
    </message>
    <message>
        <source>Holding: the tube</source>
        <translation>Gehalten: der Schlauch</translation>
    </message>
    <message>
        <source>Holding: nothing</source>
        <translation>Gehalten: nichts</translation>
    </message>
    <message>
        <source>Draw the fold of tissue back with the third instrument until its pull is in the band</source>
        <translation>Ziehen Sie die Gewebefalte mit dem dritten Instrument zurück, bis ihr Zug im Zielbereich liegt</translation>
    </message>
    <message>
        <source>Holding: the fold and two places of the tube</source>
        <translation>Gehalten: die Falte und zwei Stellen des Schlauchs</translation>
    </message>
    <message>
        <source>Holding: the fold and one place of the tube</source>
        <translation>Gehalten: die Falte und eine Stelle des Schlauchs</translation>
    </message>
    <message>
        <source>Holding: the fold</source>
        <translation>Gehalten: die Falte</translation>
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
    <name>LearningCurve</name>
    <message>
        <source>%1 over the attempts</source>
        <translation>%1 über die Versuche</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>benchmark, felt (%1)</source>
        <translation>Referenz, gefühlt (%1)</translation>
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
        <source>pass mark %1</source>
        <translation>Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>No completed attempt yet</source>
        <translation>Noch kein abgeschlossener Versuch</translation>
    </message>
</context>
<context>
    <name>LevelFacts</name>
    <message>
        <source>Tissue: normal</source>
        <translation>Gewebe: normal</translation>
    </message>
    <message>
        <source>Tissue: tight</source>
        <translation>Gewebe: eng</translation>
    </message>
    <message>
        <source>Tissue: with a stricture, a narrow and stiff ring</source>
        <translation>Gewebe: mit einer Striktur, einem engen und steifen Ring</translation>
    </message>
    <message>
        <source>Tissue: %1</source>
        <translation>Gewebe: %1</translation>
    </message>
    <message>
        <source>Depth of field: on, kept on</source>
        <translation>Schärfentiefe: an, fest eingestellt</translation>
    </message>
    <message>
        <source>Depth of field: off, kept off</source>
        <translation>Schärfentiefe: aus, fest eingestellt</translation>
    </message>
    <message>
        <source>Depth of field: on, can be switched off</source>
        <translation>Schärfentiefe: an, kann ausgeschaltet werden</translation>
    </message>
    <message>
        <source>Depth of field: off, can be switched on</source>
        <translation>Schärfentiefe: aus, kann eingeschaltet werden</translation>
    </message>
    <message>
        <source>Way: %1 mm in and out again</source>
        <translation>Weg: %1 mm hinein und wieder hinaus</translation>
    </message>
    <message>
        <source>Way: %1 mm in</source>
        <translation>Weg: %1 mm hinein</translation>
    </message>
    <message>
        <source>Help: the way is marked in the picture, and a second picture shows it from outside</source>
        <translation>Hilfe: Der Weg ist im Bild markiert, und ein zweites Bild zeigt ihn von außen</translation>
    </message>
    <message>
        <source>Help: the way is marked in the picture</source>
        <translation>Hilfe: Der Weg ist im Bild markiert</translation>
    </message>
    <message>
        <source>Help: a second picture shows the endoscope from outside</source>
        <translation>Hilfe: Ein zweites Bild zeigt das Endoskop von außen</translation>
    </message>
    <message>
        <source>Help: none, the endoscope&apos;s picture alone</source>
        <translation>Hilfe: keine, nur das Bild des Endoskops</translation>
    </message>
    <message>
        <source>Landmarks of the bladder to inspect: %1</source>
        <translation>Zu inspizierende Landmarken der Blase: %1</translation>
    </message>
    <message>
        <source>Time: %1 s at most</source>
        <translation>Zeit: höchstens %1 s</translation>
    </message>
    <message>
        <source>Trials: %1, of %2 s at most</source>
        <translation>Durchgänge: %1, je höchstens %2 s</translation>
    </message>
    <message>
        <source>Goal: a tension between %1 and %2 N, kept within ±%3 N for %4 s</source>
        <translation>Ziel: eine Spannung zwischen %1 und %2 N, auf ±%3 N genau %4 s lang gehalten</translation>
    </message>
    <message>
        <source>Goal: %1 times its length, kept for %2 s</source>
        <translation>Ziel: das %1-Fache seiner Länge, %2 s lang gehalten</translation>
    </message>
    <message>
        <source>Goal: its end handed over and held in the target for %1 s</source>
        <translation>Ziel: das Ende übergeben und %1 s lang im Ziel gehalten</translation>
    </message>
    <message>
        <source>Instruments: two, one in each hand</source>
        <translation>Instrumente: zwei, in jeder Hand eines</translation>
    </message>
    <message>
        <source>Instruments: one</source>
        <translation>Instrumente: eines</translation>
    </message>
    <message>
        <source>Tube: %1 mm long, stiffer the farther it is stretched, torn at %2 times its length</source>
        <translation>Schlauch: %1 mm lang, umso steifer, je weiter gedehnt, reißt beim %2-Fachen seiner Länge</translation>
    </message>
    <message>
        <source>Tube: %1 mm long, torn at %2 times its length</source>
        <translation>Schlauch: %1 mm lang, reißt beim %2-Fachen seiner Länge</translation>
    </message>
    <message>
        <source>Goal: the heaviest of %1 objects that look alike, in the dish</source>
        <translation>Ziel: das schwerste von %1 gleich aussehenden Objekten, in der Schale</translation>
    </message>
    <message>
        <source>Goal: the object in the dish, lifted by %1 mm on the way</source>
        <translation>Ziel: das Objekt in der Schale, unterwegs um %1 mm angehoben</translation>
    </message>
    <message>
        <source>Squeeze: %1 N at most</source>
        <translation>Quetschen: höchstens %1 N</translation>
    </message>
    <message>
        <source>Bed: a soft organ, which gives way</source>
        <translation>Unterlage: ein weiches Organ, das nachgibt</translation>
    </message>
    <message>
        <source>Hands: two, two fingers each</source>
        <translation>Hände: zwei, je zwei Finger</translation>
    </message>
    <message>
        <source>Hands: two, one finger each</source>
        <translation>Hände: zwei, je ein Finger</translation>
    </message>
    <message>
        <source>Hands: one, two fingers side by side</source>
        <translation>Hände: eine, zwei Finger nebeneinander</translation>
    </message>
    <message>
        <source>Hands: one, one finger</source>
        <translation>Hände: eine, ein Finger</translation>
    </message>
    <message>
        <source>Lumps in a trial: %1</source>
        <translation>Knoten je Durchgang: %1</translation>
    </message>
    <message>
        <source>Lumps in a trial: one or none</source>
        <translation>Knoten je Durchgang: einer oder keiner</translation>
    </message>
    <message>
        <source>Lumps in a trial: none to %1</source>
        <translation>Knoten je Durchgang: keiner bis %1</translation>
    </message>
    <message>
        <source>Lumps in a trial: %1 to %2</source>
        <translation>Knoten je Durchgang: %1 bis %2</translation>
    </message>
    <message>
        <source>where it is</source>
        <translation>wo er ist</translation>
    </message>
    <message>
        <source>how large</source>
        <translation>wie groß</translation>
    </message>
    <message>
        <source>how hard</source>
        <translation>wie hart</translation>
    </message>
    <message>
        <source>how sure you are</source>
        <translation>wie sicher Sie sind</translation>
    </message>
    <message>
        <source>To be told of each finding: %1</source>
        <translation>Zu jedem Fund anzugeben: %1</translation>
    </message>
    <message>
        <source>Press with %1 to %2 N</source>
        <translation>Mit %1 bis %2 N drücken</translation>
    </message>
    <message>
        <source>Instruments: three, one in each hand and one that holds tissue back</source>
        <translation>Instrumente: drei, eines in jeder Hand und eines, das Gewebe zurückhält</translation>
    </message>
    <message>
        <source>Over the tube: a fold of tissue, to be held back with %1 to %2 N</source>
        <translation>Über dem Schlauch: eine Gewebefalte, die mit %1 bis %2 N zurückzuhalten ist</translation>
    </message>
    <message>
        <source>Devices with a base stand as this level mounts them; what you set below takes its place</source>
        <translation>Geräte mit einer Basis stehen so, wie diese Stufe sie vorsieht; was Sie unten einstellen, hat Vorrang</translation>
    </message>
</context>
<context>
    <name>Metrics</name>
    <message>
        <source>Procedure completed</source>
        <translation>Eingriff abgeschlossen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>From the first movement or touch of each trial to its end, added up; pauses do not count.</source>
        <translation>Von der ersten Bewegung oder Berührung jedes Durchgangs bis zu seinem Ende, zusammengezählt; Pausen zählen nicht.</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Weglänge</translation>
    </message>
    <message>
        <source>How far the tip of the tool travelled in all trials together.</source>
        <translation>Wie weit die Instrumentenspitze in allen Durchgängen zusammen unterwegs war.</translation>
    </message>
    <message>
        <source>Path inefficiency</source>
        <translation>Wegüberschuss</translation>
    </message>
    <message>
        <source>How much longer the path was than the straight line between its ends or, where the way in and out is bent, than that way; the mean over the trials.</source>
        <translation>Wie viel länger der Weg war als die Gerade zwischen seinen Enden oder, wo der Weg hinein und heraus gebogen ist, als dieser; Mittelwert über die Durchgänge.</translation>
    </message>
    <message>
        <source>Smoothness (SPARC)</source>
        <translation>Flüssigkeit (SPARC)</translation>
    </message>
    <message>
        <source>How even the speed of each movement was, from its spectrum. Nearer to zero is smoother.</source>
        <translation>Wie gleichmäßig die Geschwindigkeit jeder Bewegung war, aus ihrem Spektrum. Näher an null ist flüssiger.</translation>
    </message>
    <message>
        <source>Smoothness (LDLJ)</source>
        <translation>Flüssigkeit (LDLJ)</translation>
    </message>
    <message>
        <source>How little the speed of each movement jerked. Nearer to zero is smoother.</source>
        <translation>Wie wenig die Geschwindigkeit jeder Bewegung ruckte. Näher an null ist flüssiger.</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>The largest force on the tissue at any moment.</source>
        <translation>Die größte Kraft auf das Gewebe zu irgendeinem Zeitpunkt.</translation>
    </message>
    <message>
        <source>Mean force in contact</source>
        <translation>Mittlere Kraft bei Kontakt</translation>
    </message>
    <message>
        <source>The mean force on the tissue while the tool touched it.</source>
        <translation>Die mittlere Kraft auf das Gewebe, solange das Instrument es berührte.</translation>
    </message>
    <message>
        <source>Force, root mean square</source>
        <translation>Kraft, quadratisches Mittel</translation>
    </message>
    <message>
        <source>The root of the mean squared force on the tissue: high forces weigh more than in the mean.</source>
        <translation>Die Wurzel der mittleren quadrierten Kraft auf das Gewebe: Hohe Kräfte zählen mehr als im Mittelwert.</translation>
    </message>
    <message>
        <source>Force, 95th percentile</source>
        <translation>Kraft, 95. Perzentil</translation>
    </message>
    <message>
        <source>The force on the tissue was below this for 95 % of the time.</source>
        <translation>Die Kraft auf das Gewebe lag 95 % der Zeit darunter.</translation>
    </message>
    <message>
        <source>Peak force rate</source>
        <translation>Größte Kraftänderung</translation>
    </message>
    <message>
        <source>How fast the force on the tissue rose or fell at most.</source>
        <translation>Wie schnell die Kraft auf das Gewebe höchstens stieg oder fiel.</translation>
    </message>
    <message>
        <source>Impulse over the limit</source>
        <translation>Kraftstoß über der Grenze</translation>
    </message>
    <message>
        <source>Force times time while the force was over the limit of this level.</source>
        <translation>Kraft mal Zeit, solange die Kraft über der Grenze dieser Stufe lag.</translation>
    </message>
    <message>
        <source>Time over the limit</source>
        <translation>Zeit über der Grenze</translation>
    </message>
    <message>
        <source>How long the force on the tissue was over the limit of this level.</source>
        <translation>Wie lange die Kraft auf das Gewebe über der Grenze dieser Stufe lag.</translation>
    </message>
    <message>
        <source>Apex error, mean</source>
        <translation>Scheitelfehler, Mittelwert</translation>
    </message>
    <message>
        <source>How far the marks lay from the highest point, in % of the radius; the mean over both axes and all trials, misses included.</source>
        <translation>Wie weit die Markierungen vom höchsten Punkt entfernt lagen, in % des Radius; Mittelwert über beide Achsen und alle Durchgänge, Fehlversuche eingeschlossen.</translation>
    </message>
    <message>
        <source>Apex error, standard deviation</source>
        <translation>Scheitelfehler, Standardabweichung</translation>
    </message>
    <message>
        <source>How much the error differed from mark to mark.</source>
        <translation>Wie sehr sich der Fehler von Markierung zu Markierung unterschied.</translation>
    </message>
    <message>
        <source>Apex bias, left to right</source>
        <translation>Scheitelfehler, links-rechts</translation>
    </message>
    <message>
        <source>Whether the marks lay to one side: the mean error to the right (positive) or left (negative).</source>
        <translation>Ob die Markierungen zu einer Seite lagen: der mittlere Fehler nach rechts (positiv) oder links (negativ).</translation>
    </message>
    <message>
        <source>Apex bias, front to back</source>
        <translation>Scheitelfehler, vorn-hinten</translation>
    </message>
    <message>
        <source>Whether the marks lay to one side: the mean error away from (positive) or towards (negative) the person.</source>
        <translation>Ob die Markierungen zu einer Seite lagen: der mittlere Fehler von der Person weg (positiv) oder zu ihr hin (negativ).</translation>
    </message>
    <message>
        <source>Misses</source>
        <translation>Fehlversuche</translation>
    </message>
    <message>
        <source>Trials marked without touching, marked beside the sphere, or not marked in time. Their errors count all the same.</source>
        <translation>Durchgänge, die ohne Berührung, neben der Kugel oder nicht rechtzeitig markiert wurden. Ihre Fehler zählen trotzdem.</translation>
    </message>
    <message>
        <source>the trace has no forces</source>
        <translation>die Aufzeichnung enthält keine Kräfte</translation>
    </message>
    <message>
        <source>no trials</source>
        <translation>keine Durchgänge</translation>
    </message>
    <message>
        <source>start and end are less than 5 mm apart</source>
        <translation>Anfang und Ende liegen weniger als 5 mm auseinander</translation>
    </message>
    <message>
        <source>fewer than two samples</source>
        <translation>weniger als zwei Messpunkte</translation>
    </message>
    <message>
        <source>fewer than two positions</source>
        <translation>weniger als zwei Positionen</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>kein Kontakt</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>keine Messpunkte</translation>
    </message>
    <message>
        <source>needs two trials or more</source>
        <translation>braucht mindestens zwei Durchgänge</translation>
    </message>
    <message>
        <source>neither movement nor contact</source>
        <translation>weder Bewegung noch Kontakt</translation>
    </message>
    <message>
        <source>no sub-movement of 100 ms</source>
        <translation>keine Teilbewegung von 100 ms</translation>
    </message>
    <message>
        <source>no movement</source>
        <translation>keine Bewegung</translation>
    </message>
    <message>
        <source>speed has no spectrum up to 10 Hz</source>
        <translation>die Geschwindigkeit hat kein Spektrum bis 10 Hz</translation>
    </message>
    <message>
        <source>fewer than three speed samples</source>
        <translation>weniger als drei Geschwindigkeitswerte</translation>
    </message>
    <message>
        <source>no jerk: speed changes evenly</source>
        <translation>kein Ruck: die Geschwindigkeit ändert sich gleichmäßig</translation>
    </message>
    <message>
        <source>Off-centre distance, root mean square</source>
        <translation>Auslenkung von der Mitte, quadratisches Mittel</translation>
    </message>
    <message>
        <source>How far the tip was from the middle of the urethra, on the way in and out: large distances weigh more than in the mean.</source>
        <translation>Wie weit die Spitze auf dem Weg hinein und hinaus von der Mitte der Harnröhre entfernt war: Große Abstände zählen mehr als im Mittelwert.</translation>
    </message>
    <message>
        <source>Off-centre distance, largest</source>
        <translation>Auslenkung von der Mitte, größte</translation>
    </message>
    <message>
        <source>The farthest that the tip was from the middle of the urethra.</source>
        <translation>Der größte Abstand der Spitze von der Mitte der Harnröhre.</translation>
    </message>
    <message>
        <source>Alignment, root mean square</source>
        <translation>Ausrichtung, quadratisches Mittel</translation>
    </message>
    <message>
        <source>The angle between the endoscope and the direction of the urethra where its tip was; large angles weigh more.</source>
        <translation>Der Winkel zwischen Endoskop und Richtung der Harnröhre am Ort der Spitze; große Winkel zählen mehr.</translation>
    </message>
    <message>
        <source>Alignment at the bend</source>
        <translation>Ausrichtung an der Biegung</translation>
    </message>
    <message>
        <source>The same angle on the way in, within 10 mm of the bend, where the endoscope has to be turned.</source>
        <translation>Derselbe Winkel auf dem Weg hinein, bis 10 mm vor und nach der Biegung, wo das Endoskop gedreht werden muss.</translation>
    </message>
    <message>
        <source>Alignment round the bend</source>
        <translation>Ausrichtung in der Biegung</translation>
    </message>
    <message>
        <source>The same angle on the way in, from the bend to 30 mm past it, where the urethra is curved most.</source>
        <translation>Derselbe Winkel auf dem Weg hinein, von der Biegung bis 30 mm dahinter, wo die Harnröhre am stärksten gekrümmt ist.</translation>
    </message>
    <message>
        <source>Trauma events</source>
        <translation>Verletzungsereignisse</translation>
    </message>
    <message>
        <source>How often the endoscope pressed sideways on the wall over the limit of this level for 20 ms or longer.</source>
        <translation>Wie oft das Endoskop 20 ms oder länger seitlich stärker gegen die Wand drückte, als die Grenze dieser Stufe erlaubt.</translation>
    </message>
    <message>
        <source>Time of trauma</source>
        <translation>Verletzungszeit</translation>
    </message>
    <message>
        <source>How long those events lasted together.</source>
        <translation>Wie lange diese Ereignisse zusammen dauerten.</translation>
    </message>
    <message>
        <source>Impulse of trauma</source>
        <translation>Verletzungsimpuls</translation>
    </message>
    <message>
        <source>Sideways force times time while that force was over the limit of this level.</source>
        <translation>Seitenkraft mal Zeit, solange diese Kraft über der Grenze dieser Stufe lag.</translation>
    </message>
    <message>
        <source>Largest sideways force</source>
        <translation>Größte Seitenkraft</translation>
    </message>
    <message>
        <source>The largest force with which the endoscope pressed sideways on the wall at any moment.</source>
        <translation>Die größte Kraft, mit der das Endoskop in irgendeinem Augenblick seitlich gegen die Wand drückte.</translation>
    </message>
    <message>
        <source>Advance while turning</source>
        <translation>Vorschub beim Drehen</translation>
    </message>
    <message>
        <source>How far the endoscope was pushed on in the bend while it was being turned: stop, turn, and only then go on.</source>
        <translation>Wie weit das Endoskop in der Biegung vorgeschoben wurde, während es gedreht wurde: anhalten, drehen und erst dann weitergehen.</translation>
    </message>
    <message>
        <source>Largest torque</source>
        <translation>Größtes Drehmoment</translation>
    </message>
    <message>
        <source>The largest torque between endoscope and tissue at any moment.</source>
        <translation>Das größte Drehmoment zwischen Endoskop und Gewebe zu irgendeinem Zeitpunkt.</translation>
    </message>
    <message>
        <source>Torque, root mean square</source>
        <translation>Drehmoment, quadratisches Mittel</translation>
    </message>
    <message>
        <source>The root of the mean squared torque between endoscope and tissue.</source>
        <translation>Die Wurzel aus dem mittleren Quadrat des Drehmoments zwischen Endoskop und Gewebe.</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>Rückwärtsbewegungen</translation>
    </message>
    <message>
        <source>How often the tip went back by 1 mm or more on the way in.</source>
        <translation>Wie oft die Spitze auf dem Weg hinein um 1 mm oder mehr zurückging.</translation>
    </message>
    <message>
        <source>Landmarks seen</source>
        <translation>Gesehene Landmarken</translation>
    </message>
    <message>
        <source>The landmarks of the bladder that were inspected, in % of those that the level asks for.</source>
        <translation>Die inspizierten Landmarken der Blase, in % derer, die die Stufe verlangt.</translation>
    </message>
    <message>
        <source>Tip travel during inspection</source>
        <translation>Weg der Spitze bei der Inspektion</translation>
    </message>
    <message>
        <source>How far the tip travelled while the bladder was inspected: turning it shows as much and harms less.</source>
        <translation>Wie weit sich die Spitze bewegte, während die Blase inspiziert wurde: Drehen zeigt ebenso viel und schadet weniger.</translation>
    </message>
    <message>
        <source>Insertion depth</source>
        <translation>Einführtiefe</translation>
    </message>
    <message>
        <source>The deepest place that the tip reached, up to the goal of this level.</source>
        <translation>Die tiefste Stelle, die die Spitze erreichte, höchstens das Ziel dieser Stufe.</translation>
    </message>
    <message>
        <source>the trace has no insertion data</source>
        <translation>die Aufzeichnung enthält keine Daten zum Einführen</translation>
    </message>
    <message>
        <source>the trace has no torques</source>
        <translation>die Aufzeichnung enthält keine Drehmomente</translation>
    </message>
    <message>
        <source>the tip was never in the urethra</source>
        <translation>die Spitze war nie in der Harnröhre</translation>
    </message>
    <message>
        <source>the tip was never at the bend</source>
        <translation>die Spitze war nie an der Biegung</translation>
    </message>
    <message>
        <source>the level has no landmarks</source>
        <translation>die Stufe hat keine Landmarken</translation>
    </message>
    <message>
        <source>the inspection was not reached</source>
        <translation>die Inspektion wurde nicht erreicht</translation>
    </message>
    <message>
        <source>published, 5 subjects × 10</source>
        <translation>veröffentlicht, 5 Personen × 10</translation>
    </message>
    <message>
        <source>% of R</source>
        <translation>%&#xa0;von&#xa0;R</translation>
    </message>
    <message>
        <source>How many of the trials were done to their end in time, with everything that the level asks for, in %.</source>
        <translation>Wie viele der Durchgänge rechtzeitig zu Ende geführt wurden, mit allem, was die Stufe verlangt, in %.</translation>
    </message>
    <message>
        <source>Tension error, root mean square</source>
        <translation>Spannungsfehler, quadratisches Mittel</translation>
    </message>
    <message>
        <source>How far the tension of the tube was from its target while it was held: large differences weigh more than in the mean.</source>
        <translation>Wie weit die Spannung des Schlauchs während des Haltens von ihrem Ziel abwich: Große Abweichungen zählen mehr als im Mittel.</translation>
    </message>
    <message>
        <source>Tension error, standard deviation</source>
        <translation>Spannungsfehler, Standardabweichung</translation>
    </message>
    <message>
        <source>How unsteady the tension of the tube was while it was held, whether on target or beside it.</source>
        <translation>Wie unruhig die Spannung des Schlauchs während des Haltens war, ob am Ziel oder daneben.</translation>
    </message>
    <message>
        <source>Time in the band</source>
        <translation>Zeit im Bereich</translation>
    </message>
    <message>
        <source>How long the tension, or the length at the mark, was where it had to be during the hold; the mean over all trials.</source>
        <translation>Wie lange die Spannung, oder die Länge an der Marke, während des Haltens dort war, wo sie sein sollte; Mittel über alle Durchgänge.</translation>
    </message>
    <message>
        <source>Critical errors</source>
        <translation>Kritische Fehler</translation>
    </message>
    <message>
        <source>How often the tissue gave way because it was pushed or turned too hard, or was pressed sideways too hard or for too long.</source>
        <translation>Wie oft das Gewebe nachgab, weil zu stark gedrückt oder verdreht wurde, oder zu stark oder zu lange zur Seite gedrückt wurde.</translation>
    </message>
    <message>
        <source>Over-stretches</source>
        <translation>Überdehnungen</translation>
    </message>
    <message>
        <source>How often the tube was stretched beyond the limit of this level.</source>
        <translation>Wie oft der Schlauch über die Grenze dieser Stufe hinaus gedehnt wurde.</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Fallengelassen</translation>
    </message>
    <message>
        <source>How often the tissue was let go of before the task was done.</source>
        <translation>Wie oft das Gewebe losgelassen wurde, bevor die Aufgabe erfüllt war.</translation>
    </message>
    <message>
        <source>Largest squeeze</source>
        <translation>Größte Quetschkraft</translation>
    </message>
    <message>
        <source>The largest force with which a jaw squeezed what it held.</source>
        <translation>Die größte Kraft, mit der ein Maul quetschte, was es hielt.</translation>
    </message>
    <message>
        <source>Time squeezed too hard</source>
        <translation>Zeit zu fest gequetscht</translation>
    </message>
    <message>
        <source>How long the squeeze was over the limit of this level.</source>
        <translation>Wie lange die Quetschkraft über der Grenze dieser Stufe lag.</translation>
    </message>
    <message>
        <source>Placement error</source>
        <translation>Ablagefehler</translation>
    </message>
    <message>
        <source>How far from the middle of the target the object lay at the end of each trial; the mean over the trials.</source>
        <translation>Wie weit das Objekt am Ende jedes Durchgangs von der Zielmitte lag; Mittel über die Durchgänge.</translation>
    </message>
    <message>
        <source>Heaviest found</source>
        <translation>Schwerstes gefunden</translation>
    </message>
    <message>
        <source>How often the heaviest object was laid into the target, in % of the trials.</source>
        <translation>Wie oft das schwerste Objekt ins Ziel gelegt wurde, in % der Durchgänge.</translation>
    </message>
    <message>
        <source>the trace has no procedure</source>
        <translation>die Aufzeichnung enthält keinen Eingriff</translation>
    </message>
    <message>
        <source>the trace has no squeeze</source>
        <translation>die Aufzeichnung enthält keine Quetschkraft</translation>
    </message>
    <message>
        <source>the trace has no squeeze limit</source>
        <translation>die Aufzeichnung enthält keine Grenze der Quetschkraft</translation>
    </message>
    <message>
        <source>the trace has no objects and target</source>
        <translation>die Aufzeichnung enthält weder Objekte noch Ziel</translation>
    </message>
    <message>
        <source>no weighing was asked for</source>
        <translation>es war kein Wägen verlangt</translation>
    </message>
    <message>
        <source>the trace has no data of a tube</source>
        <translation>die Aufzeichnung enthält keine Daten eines Schlauchs</translation>
    </message>
    <message>
        <source>the task has no such target</source>
        <translation>die Aufgabe hat kein solches Ziel</translation>
    </message>
    <message>
        <source>the tension was never held</source>
        <translation>die Spannung wurde nie gehalten</translation>
    </message>
    <message>
        <source>Lumps found</source>
        <translation>Gefundene Knoten</translation>
    </message>
    <message>
        <source>Lumps that one of the findings was near enough to. A lump that was pressed harder than the limit does not count.</source>
        <translation>Knoten, denen ein Fund nahe genug kam. Ein Knoten, auf den stärker als bis zur Grenze gedrückt wurde, zählt nicht.</translation>
    </message>
    <message>
        <source>Lumps missed</source>
        <translation>Übersehene Knoten</translation>
    </message>
    <message>
        <source>Lumps that no finding was near enough to.</source>
        <translation>Knoten, denen kein Fund nahe genug kam.</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>Falsche Alarme</translation>
    </message>
    <message>
        <source>Findings where there was no lump; a second one of the same lump counts too.</source>
        <translation>Funde, wo kein Knoten war; ein zweiter desselben Knotens zählt auch.</translation>
    </message>
    <message>
        <source>Sensitivity (d′)</source>
        <translation>Empfindlichkeit (d′)</translation>
    </message>
    <message>
        <source>How well places with a lump were told from places without, whether one rather says yes or no. 0 is chance.</source>
        <translation>Wie gut Stellen mit und ohne Knoten unterschieden wurden, gleich ob man eher ja oder nein sagt. 0 ist Zufall.</translation>
    </message>
    <message>
        <source>Criterion (c)</source>
        <translation>Kriterium (c)</translation>
    </message>
    <message>
        <source>Whether a lump is rather reported (negative) or rather not (positive) when in doubt.</source>
        <translation>Ob im Zweifel eher ein Knoten gemeldet wird (negativ) oder eher nicht (positiv).</translation>
    </message>
    <message>
        <source>Area under the ROC</source>
        <translation>Fläche unter der ROC-Kurve</translation>
    </message>
    <message>
        <source>How well confidence tells places with a lump from places without: 0.5 says nothing, 1 is perfect.</source>
        <translation>Wie gut die Sicherheit Stellen mit und ohne Knoten unterscheidet: 0,5 sagt nichts, 1 ist vollkommen.</translation>
    </message>
    <message>
        <source>Localisation error</source>
        <translation>Lagefehler</translation>
    </message>
    <message>
        <source>How far the findings lay from the lumps that they found, on the surface; the mean over all found.</source>
        <translation>Wie weit die Funde auf der Oberfläche von ihren Knoten lagen; Mittel über alle gefundenen.</translation>
    </message>
    <message>
        <source>Size error</source>
        <translation>Größenfehler</translation>
    </message>
    <message>
        <source>How far the radius that was said was from the true one; the mean over all lumps found whose size was said.</source>
        <translation>Wie weit der angegebene Radius vom wahren abwich; Mittel über alle gefundenen Knoten mit angegebener Größe.</translation>
    </message>
    <message>
        <source>Sensitivity, at least</source>
        <translation>Empfindlichkeit, mindestens</translation>
    </message>
    <message>
        <source>The lower end of the 95 % interval of the sensitivity. Below 0 the session does not show that anything was felt.</source>
        <translation>Das untere Ende des 95-%-Intervalls der Empfindlichkeit. Unter 0 zeigt die Sitzung nicht, dass etwas gefühlt wurde.</translation>
    </message>
    <message>
        <source>Sensitivity, at most</source>
        <translation>Empfindlichkeit, höchstens</translation>
    </message>
    <message>
        <source>The upper end of the 95 % interval of the sensitivity.</source>
        <translation>Das obere Ende des 95-%-Intervalls der Empfindlichkeit.</translation>
    </message>
    <message>
        <source>Prediction error at 30 Hz</source>
        <translation>Vorhersagefehler bei 30 Hz</translation>
    </message>
    <message>
        <source>How far the soft surface under the tool was from what the slow model then said; this is about the simulation, not about you.</source>
        <translation>Wie weit die weiche Oberfläche unter dem Instrument von dem entfernt war, was das langsame Modell dann ergab; das betrifft die Simulation, nicht Sie.</translation>
    </message>
    <message>
        <source>Error without prediction</source>
        <translation>Fehler ohne Vorhersage</translation>
    </message>
    <message>
        <source>The same if the last update had been held: what the prediction is worth.</source>
        <translation>Dasselbe, wenn der letzte Stand gehalten worden wäre: was die Vorhersage wert ist.</translation>
    </message>
    <message>
        <source>no trial was finished</source>
        <translation>kein Durchgang wurde beendet</translation>
    </message>
    <message>
        <source>the trial was not finished</source>
        <translation>der Durchgang wurde nicht beendet</translation>
    </message>
    <message>
        <source>one trial alone has no chance level</source>
        <translation>für einen einzelnen Durchgang gibt es kein Zufallsniveau</translation>
    </message>
    <message>
        <source>no two lumps of different hardness were found and rated</source>
        <translation>es wurden keine zwei verschieden harten Knoten gefunden und bewertet</translation>
    </message>
    <message>
        <source>fewer than two lumps were found and their hardness said</source>
        <translation>es wurden weniger als zwei Knoten gefunden und ihre Härte angegeben</translation>
    </message>
    <message>
        <source>fewer than two lumps were there</source>
        <translation>es gab weniger als zwei Knoten</translation>
    </message>
    <message>
        <source>nothing was touched, so nothing was predicted</source>
        <translation>es wurde nichts berührt, also auch nichts vorhergesagt</translation>
    </message>
    <message>
        <source>the trace has no prediction</source>
        <translation>die Aufzeichnung enthält keine Vorhersage</translation>
    </message>
    <message>
        <source>Heaviest found by chance</source>
        <translation>Schwerstes durch Raten gefunden</translation>
    </message>
    <message>
        <source>How often the heaviest is chosen by somebody who feels nothing. A share that is not larger shows no skill.</source>
        <translation>Wie oft jemand das Schwerste wählt, der nichts fühlt. Ein Anteil, der nicht größer ist, zeigt kein Können.</translation>
    </message>
    <message>
        <source>Localisation error by chance</source>
        <translation>Lagefehler durch Raten</translation>
    </message>
    <message>
        <source>How far findings lie from a lump if they hit it without aim. A localisation error that is not smaller shows no skill.</source>
        <translation>Wie weit Befunde von einem Knoten liegen, wenn sie ihn ohne Zielen treffen. Ein Lagefehler, der nicht kleiner ist, zeigt kein Können.</translation>
    </message>
    <message>
        <source>Hardness order by chance</source>
        <translation>Reihenfolge der Härte durch Raten</translation>
    </message>
    <message>
        <source>The hardness order of somebody who says the same words of the lumps in random order. A share that is not larger shows no skill.</source>
        <translation>Die Reihenfolge der Härte von jemandem, der dieselben Worte in zufälliger Reihenfolge über die Knoten sagt. Ein Anteil, der nicht größer ist, zeigt kein Können.</translation>
    </message>
    <message>
        <source>Apex error by chance</source>
        <translation>Scheitelfehler durch Raten</translation>
    </message>
    <message>
        <source>The apex error of somebody who feels nothing and always marks the same place, the best one. An error that is not smaller shows no skill.</source>
        <translation>Der Scheitelfehler von jemandem, der nichts fühlt und immer dieselbe Stelle markiert, die beste. Ein Fehler, der nicht kleiner ist, zeigt kein Können.</translation>
    </message>
    <message>
        <source>Size error by chance</source>
        <translation>Größenfehler durch Raten</translation>
    </message>
    <message>
        <source>The size error of somebody who feels nothing and always says the middle size. A size error that is not smaller shows no skill.</source>
        <translation>Der Größenfehler von jemandem, der nichts fühlt und immer die mittlere Größe angibt. Ein Größenfehler, der nicht kleiner ist, zeigt kein Können.</translation>
    </message>
    <message>
        <source>Hardness order</source>
        <translation>Reihenfolge der Härte</translation>
    </message>
    <message>
        <source>Of the pairs of lumps found in a trial, how many had the harder one called harder, in %. By chance it is 50 % or less.</source>
        <translation>Bei wie vielen Paaren gefundener Knoten eines Durchgangs der härtere auch härter genannt wurde, in %. Durch Raten sind es höchstens 50 %.</translation>
    </message>
    <message>
        <source>Area covered</source>
        <translation>Abgetastete Fläche</translation>
    </message>
    <message>
        <source>How much of the search area was pressed hard enough to find something; the mean over the trials.</source>
        <translation>Wie viel des Suchfelds fest genug gedrückt wurde, um etwas zu finden; Mittel über die Durchgänge.</translation>
    </message>
    <message>
        <source>Time in the force band</source>
        <translation>Zeit im Kraftband</translation>
    </message>
    <message>
        <source>For how much of the time pressing the force was neither too light nor too hard.</source>
        <translation>In welchem Teil der Druckzeit die Kraft weder zu leicht noch zu stark war.</translation>
    </message>
    <message>
        <source>Time pressing</source>
        <translation>Druckzeit</translation>
    </message>
    <message>
        <source>How long a finger pressed the tissue, in all trials together.</source>
        <translation>Wie lange ein Finger das Gewebe drückte, in allen Durchgängen zusammen.</translation>
    </message>
    <message>
        <source>Time searching</source>
        <translation>Suchzeit</translation>
    </message>
    <message>
        <source>How long the trials took until done was said; pauses do not count.</source>
        <translation>Wie lange die Durchgänge bis zur Fertigmeldung dauerten; Pausen zählen nicht.</translation>
    </message>
    <message>
        <source>the trace has no lumps and search area</source>
        <translation>die Aufzeichnung enthält weder Knoten noch Suchfeld</translation>
    </message>
    <message>
        <source>the trace has no reports</source>
        <translation>die Aufzeichnung enthält keine Meldungen</translation>
    </message>
    <message>
        <source>the trace lost reports</source>
        <translation>in der Aufzeichnung fehlen Meldungen</translation>
    </message>
    <message>
        <source>no lump was there</source>
        <translation>es gab keinen Knoten</translation>
    </message>
    <message>
        <source>no lump was found</source>
        <translation>es wurde kein Knoten gefunden</translation>
    </message>
    <message>
        <source>nobody said how sure a finding is</source>
        <translation>zu keinem Fund wurde die Sicherheit angegeben</translation>
    </message>
    <message>
        <source>of no lump that was found the size was said</source>
        <translation>zu keinem gefundenen Knoten wurde die Größe angegeben</translation>
    </message>
    <message>
        <source>the level asks for no size</source>
        <translation>die Stufe fragt nicht nach der Größe</translation>
    </message>
    <message>
        <source>the level asks for no hardness</source>
        <translation>die Stufe fragt nicht nach der Härte</translation>
    </message>
    <message>
        <source>fewer than two lumps of a trial were found and their hardness said</source>
        <translation>in keinem Durchgang wurden zwei Knoten gefunden und ihre Härte angegeben</translation>
    </message>
    <message>
        <source>the lumps that were found are equally hard</source>
        <translation>die gefundenen Knoten sind gleich hart</translation>
    </message>
    <message>
        <source>the trace has no coverage</source>
        <translation>die Aufzeichnung enthält keine abgetastete Fläche</translation>
    </message>
    <message>
        <source>the trace has no force band</source>
        <translation>die Aufzeichnung enthält kein Kraftband</translation>
    </message>
    <message>
        <source>nothing was pressed</source>
        <translation>es wurde nichts gedrückt</translation>
    </message>
    <message>
        <source>only %1 regions with a lump and %2 without: %3 of each are needed</source>
        <translation>nur %1 Felder mit Knoten und %2 ohne: je %3 sind nötig</translation>
    </message>
    <message>
        <source>Retraction in the band</source>
        <translation>Zug der Falte im Zielbereich</translation>
    </message>
    <message>
        <source>How much of the time, once the fold of tissue was held back, its pull was where it had to be, in %; the mean over all trials.</source>
        <translation>Wie viel der Zeit, seit die Gewebefalte zurückgehalten wurde, ihr Zug dort lag, wo er liegen sollte, in %; Mittel über alle Durchgänge.</translation>
    </message>
    <message>
        <source>Largest retraction</source>
        <translation>Größter Zug an der Falte</translation>
    </message>
    <message>
        <source>The largest pull on the fold of tissue at any moment.</source>
        <translation>Der größte Zug an der Gewebefalte zu irgendeinem Zeitpunkt.</translation>
    </message>
    <message>
        <source>no position to score</source>
        <translation>keine Position, die gewertet werden könnte</translation>
    </message>
    <message>
        <source>the apex&apos;s true place is not known</source>
        <translation>die wahre Lage des Scheitels ist nicht bekannt</translation>
    </message>
</context>
<context>
    <name>PalpationFindings</name>
    <message>
        <source>size said %1, was %2</source>
        <translation>Größe angegeben %1, war %2</translation>
    </message>
    <message>
        <source>hardness said %1, was %2</source>
        <translation>Härte angegeben %1, war %2</translation>
    </message>
    <message>
        <source>confidence: %1</source>
        <translation>Sicherheit: %1</translation>
    </message>
    <message>
        <source>Lump %1 (%2, %3 mm deep): missed</source>
        <translation>Knoten %1 (%2, %3 mm tief): übersehen</translation>
    </message>
    <message>
        <source>Lump %1: found, finding %2, %3 mm beside its middle</source>
        <translation>Knoten %1: gefunden, Fund %2, %3 mm neben der Mitte</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>There was no lump, and none was reported.</source>
        <translation>Es gab keinen Knoten, und keiner wurde gemeldet.</translation>
    </message>
    <message>
        <source>There was no lump.</source>
        <translation>Es gab keinen Knoten.</translation>
    </message>
    <message>
        <source>Lumps found: %1 of %2.</source>
        <translation>Gefundene Knoten: %1 von %2.</translation>
    </message>
    <message>
        <source>Findings where no lump was: %1.</source>
        <translation>Funde, wo kein Knoten war: %1.</translation>
    </message>
    <message>
        <source>Searched: %1 %.</source>
        <translation>Abgetastet: %1 %.</translation>
    </message>
    <message>
        <source>Time was up before the end was reported.</source>
        <translation>Die Zeit war um, bevor das Ende gemeldet wurde.</translation>
    </message>
    <message>
        <source>Finding %1: no lump there; the nearest was %2 mm away</source>
        <translation>Fund %1: dort war kein Knoten; der nächste lag %2 mm entfernt</translation>
    </message>
    <message>
        <source>Finding %1: no lump there</source>
        <translation>Fund %1: dort war kein Knoten</translation>
    </message>
</context>
<context>
    <name>PalpationWords</name>
    <message>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>confidence</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>rather soft</source>
        <translation>eher weich</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>firm</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>stony</source>
        <translation>steinhart</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>a guess</source>
        <translation>geraten</translation>
    </message>
    <message>
        <source>unsure</source>
        <translation>unsicher</translation>
    </message>
    <message>
        <source>fairly sure</source>
        <translation>ziemlich sicher</translation>
    </message>
    <message>
        <source>sure</source>
        <translation>sicher</translation>
    </message>
    <message>
        <source>certain</source>
        <translation>ganz sicher</translation>
    </message>
    <message>
        <source>%1 mm across</source>
        <translation>%1 mm Durchmesser</translation>
    </message>
    <message>
        <source>size not said</source>
        <translation>Größe nicht angegeben</translation>
    </message>
    <message>
        <source>hardness not said</source>
        <translation>Härte nicht angegeben</translation>
    </message>
    <message>
        <source>confidence not said</source>
        <translation>Sicherheit nicht angegeben</translation>
    </message>
    <message>
        <source>Finding %1</source>
        <translation>Fund %1</translation>
    </message>
    <message>
        <source>Finding %1: %2</source>
        <translation>Fund %1: %2</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>Middle finger</source>
        <translation>Mittelfinger</translation>
    </message>
    <message>
        <source>Index finger</source>
        <translation>Zeigefinger</translation>
    </message>
    <message>
        <source>Right middle finger</source>
        <translation>Rechter Mittelfinger</translation>
    </message>
    <message>
        <source>Right index finger</source>
        <translation>Rechter Zeigefinger</translation>
    </message>
    <message>
        <source>Left middle finger</source>
        <translation>Linker Mittelfinger</translation>
    </message>
    <message>
        <source>Left index finger</source>
        <translation>Linker Zeigefinger</translation>
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
        <translation>Rauschen, Hysterese und Kriechen der Kraftsensoren</translation>
    </message>
    <message>
        <source>Steps of the converter</source>
        <translation>Stufen des Wandlers</translation>
    </message>
    <message>
        <source>Delay of the force sensors</source>
        <translation>Verzögerung der Kraftsensoren</translation>
    </message>
    <message>
        <source>Friction of the drives</source>
        <translation>Reibung der Antriebe</translation>
    </message>
    <message>
        <source>Backlash of the gears</source>
        <translation>Spiel der Getriebe</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>× %1 as coarse</source>
        <translation>× %1 so grob</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>This is the simulated platform, with a plant that is as bad as such parts are: force noise of %1 mN and %2 bits of the converter, hysteresis of %3 %, a delay of %4 ms from sensor to controller, gear friction of %5 N a drive, backlash of %6 µm, an orientation sensor with %7° bias and %8° noise.</source>
        <translation>Dies ist die simulierte Plattform, so unvollkommen wie solche Teile sind: %1 mN Rauschen der Kraft und %2 Bit des Wandlers, %3 % Hysterese, %4 ms Verzögerung vom Sensor zum Regler, %5 N Getriebereibung je Antrieb, %6 µm Spiel, ein Lagesensor mit %7° Versatz und %8° Rauschen.</translation>
    </message>
    <message>
        <source>Friction as identified by moving the drives: %1 N, and %2 N·s/m with speed.</source>
        <translation>Reibung, durch Bewegen der Antriebe bestimmt: %1 N, mit der Geschwindigkeit %2 N·s/m.</translation>
    </message>
    <message>
        <source>A step of force is felt after %1 ms. With the damping of drives and pad alone, a wall is stable up to %2 N/mm.</source>
        <translation>Ein Kraftsprung ist nach %1 ms zu spüren. Allein mit der Dämpfung von Antrieben und Fingerkuppe ist eine Wand bis %2 N/mm stabil.</translation>
    </message>
    <message>
        <source>Noise and offset of the orientation sensor</source>
        <translation>Rauschen und Versatz des Lagesensors</translation>
    </message>
    <message>
        <source>A simulation: the simulated platform stays within its bounds on %1 of %2 simulated fingers. At worst, the pad&apos;s force is off by %3 (root mean square), the orientation by %4, a step overshoots by %5 % of the force, and the pad gets at most %6 (%7). A real platform has to be measured on its own.</source>
        <translation>Eine Simulation: Die simulierte Plattform hält ihre Grenzen an %1 von %2 simulierten Fingern ein. Im schlechtesten Fall weicht die Kraft an der Fingerkuppe um %3 ab (quadratisches Mittel), die Neigung um %4, ein Sprung schwingt um %5 % der Kraft über, und die Fingerkuppe bekommt höchstens %6 (%7). Eine echte Plattform muss eigens gemessen werden.</translation>
    </message>
    <message>
        <source>bounds: %1, %2, %3 %, %4</source>
        <translation>Grenzen: %1, %2, %3 %, %4</translation>
    </message>
    <message>
        <source>Half as stiff</source>
        <translation>Halb so steif</translation>
    </message>
    <message>
        <source>Twice as stiff</source>
        <translation>Doppelt so steif</translation>
    </message>
    <message>
        <source>Thick</source>
        <translation>Dick</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Dünn</translation>
    </message>
    <message>
        <source>Its force relaxes by 40 %</source>
        <translation>Die Kraft lässt um 40 % nach</translation>
    </message>
    <message>
        <source>Half as stiff, thick, relaxing</source>
        <translation>Halb so steif, dick, nachlassend</translation>
    </message>
    <message>
        <source>Twice as stiff, thin, relaxing</source>
        <translation>Doppelt so steif, dünn, nachlassend</translation>
    </message>
    <message>
        <source>The finger that is assumed</source>
        <translation>Der angenommene Finger</translation>
    </message>
    <message>
        <source>On other fingers: what the pad really got</source>
        <translation>An anderen Fingern: was die Fingerkuppe wirklich bekam</translation>
    </message>
    <message>
        <source>Simulated finger</source>
        <translation>Simulierter Finger</translation>
    </message>
    <message>
        <source>Gain, phase</source>
        <translation>Verstärkung, Phase</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>Most at 1 N</source>
        <translation>Max. bei 1 N</translation>
    </message>
    <message>
        <source>Most at 4 N</source>
        <translation>Max. bei 4 N</translation>
    </message>
    <message>
        <source>Within its bounds</source>
        <translation>In den Grenzen</translation>
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
        <source>Beside the published figures</source>
        <translation>Neben den veröffentlichten Werten</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>By its own sensors</source>
        <translation>Nach den eigenen Sensoren</translation>
    </message>
    <message>
        <source>What was really so</source>
        <translation>Was wirklich war</translation>
    </message>
    <message>
        <source>Published (P3)</source>
        <translation>Veröffentlicht (P3)</translation>
    </message>
    <message>
        <source>Force, cycle %1: root mean square error</source>
        <translation>Kraft, Periode %1: quadratischer Mittelwert des Fehlers</translation>
    </message>
    <message>
        <source>Force, mean of the cycles</source>
        <translation>Kraft, Mittel der Perioden</translation>
    </message>
    <message>
        <source>Orientation, mean error of %1 poses</source>
        <translation>Neigung, mittlerer Fehler aus %1 Stellungen</translation>
    </message>
    <message>
        <source>Orientation, standard deviation</source>
        <translation>Neigung, Standardabweichung</translation>
    </message>
    <message>
        <source>Force error</source>
        <translation>Kraftfehler</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>When one thing gets worse</source>
        <translation>Wenn eines schlechter wird</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Wie viel</translation>
    </message>
    <message>
        <source>Orientation error</source>
        <translation>Fehler der Neigung</translation>
    </message>
</context>
<context>
    <name>PlatformPlots</name>
    <message>
        <source>Force over three cycles</source>
        <translation>Kraft über drei Perioden</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>sensed</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>on the pad</source>
        <translation>an der Fingerkuppe</translation>
    </message>
    <message>
        <source>wanted</source>
        <translation>Soll</translation>
    </message>
    <message>
        <source>Orientations, sensed over wanted</source>
        <translation>Neigungen, gemessen über Soll</translation>
    </message>
    <message>
        <source>Wanted (°)</source>
        <translation>Soll (°)</translation>
    </message>
    <message>
        <source>Sensed (°)</source>
        <translation>Gemessen (°)</translation>
    </message>
    <message>
        <source>as wanted</source>
        <translation>wie gewollt</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>How large the errors of orientation were</source>
        <translation>Wie groß die Fehler der Neigung waren</translation>
    </message>
    <message>
        <source>Error (°)</source>
        <translation>Fehler (°)</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Stellungen</translation>
    </message>
    <message>
        <source>poses</source>
        <translation>Stellungen</translation>
    </message>
</context>
<context>
    <name>PlaybackMarks</name>
    <message>
        <source>Force held: the tool moved too fast</source>
        <translation>Kraft zurückgehalten: Instrument zu schnell</translation>
    </message>
    <message>
        <source>A sample of the device was not usable</source>
        <translation>Ein Messpunkt des Geräts war unbrauchbar</translation>
    </message>
    <message>
        <source>Fault: too many samples of the device were not usable</source>
        <translation>Störung: zu viele unbrauchbare Messpunkte des Geräts</translation>
    </message>
    <message>
        <source>Force held: samples of the device came late</source>
        <translation>Kraft zurückgehalten: Daten des Geräts kamen verspätet</translation>
    </message>
    <message>
        <source>Fault: the device went silent</source>
        <translation>Störung: Das Gerät verstummte</translation>
    </message>
    <message>
        <source>Force held: the window did not answer</source>
        <translation>Kraft zurückgehalten: Das Fenster reagierte nicht</translation>
    </message>
    <message>
        <source>Force damped to keep it stable</source>
        <translation>Kraft gedämpft, damit sie stabil bleibt</translation>
    </message>
    <message>
        <source>Fault: the device reported one</source>
        <translation>Störung: vom Gerät gemeldet</translation>
    </message>
    <message>
        <source>The force supervisor stepped in</source>
        <translation>Die Sicherheitsüberwachung griff ein</translation>
    </message>
    <message>
        <source>Trial %1 begins</source>
        <translation>Durchgang %1 beginnt</translation>
    </message>
    <message>
        <source>Marked the highest point</source>
        <translation>Höchsten Punkt markiert</translation>
    </message>
    <message>
        <source>Time was up without a mark</source>
        <translation>Zeit abgelaufen ohne Markierung</translation>
    </message>
    <message>
        <source>The trace ended without a mark</source>
        <translation>Aufzeichnung endete ohne Markierung</translation>
    </message>
    <message>
        <source>In contact for %1</source>
        <translation>%1 lang in Kontakt</translation>
    </message>
    <message>
        <source>Over the limit for %1, up to %2</source>
        <translation>%1 lang über der Grenze, bis %2</translation>
    </message>
    <message>
        <source>Paused for %1</source>
        <translation>%1 lang Pause</translation>
    </message>
    <message>
        <source>Force armed again</source>
        <translation>Kraft wieder freigegeben</translation>
    </message>
    <message>
        <source>The person ended the session</source>
        <translation>Die Person beendete die Sitzung</translation>
    </message>
    <message>
        <source>The insertion begins</source>
        <translation>Das Einführen beginnt</translation>
    </message>
    <message>
        <source>The inspection begins</source>
        <translation>Die Inspektion beginnt</translation>
    </message>
    <message>
        <source>The withdrawal begins</source>
        <translation>Der Rückzug beginnt</translation>
    </message>
    <message>
        <source>Step: take hold</source>
        <translation>Schritt: greifen</translation>
    </message>
    <message>
        <source>Step: stretch</source>
        <translation>Schritt: dehnen</translation>
    </message>
    <message>
        <source>Step: hold still</source>
        <translation>Schritt: ruhig halten</translation>
    </message>
    <message>
        <source>Step: hand over</source>
        <translation>Schritt: übergeben</translation>
    </message>
    <message>
        <source>Step: lift</source>
        <translation>Schritt: anheben</translation>
    </message>
    <message>
        <source>Step: carry to the target</source>
        <translation>Schritt: zum Ziel führen</translation>
    </message>
    <message>
        <source>Step: set down</source>
        <translation>Schritt: ablegen</translation>
    </message>
    <message>
        <source>Step: hold the tissue back</source>
        <translation>Schritt: Gewebe zurückhalten</translation>
    </message>
    <message>
        <source>The next stage begins</source>
        <translation>Die nächste Phase beginnt</translation>
    </message>
    <message>
        <source>Landmarks seen: %1</source>
        <translation>Gesehene Landmarken: %1</translation>
    </message>
    <message>
        <source>A landmark was seen</source>
        <translation>Eine Landmarke wurde gesehen</translation>
    </message>
    <message>
        <source>Pressed on the wall for %1, up to %2</source>
        <translation>%1 lang gegen die Wand gedrückt, mit bis zu %2</translation>
    </message>
    <message>
        <source>Went back by %1</source>
        <translation>Um %1 zurückgegangen</translation>
    </message>
    <message>
        <source>Off the middle for %1, up to %2</source>
        <translation>%1 lang von der Mitte ausgelenkt, um bis zu %2</translation>
    </message>
    <message>
        <source>Torque over its limit for %1, up to %2</source>
        <translation>Drehmoment %1 lang über seiner Grenze, mit bis zu %2</translation>
    </message>
    <message>
        <source>Took hold</source>
        <translation>Gefasst</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Losgelassen</translation>
    </message>
    <message>
        <source>Slipped out or dropped</source>
        <translation>Entglitten oder fallen gelassen</translation>
    </message>
    <message>
        <source>Critical error: %1</source>
        <translation>Kritischer Fehler: %1</translation>
    </message>
    <message>
        <source>The tissue gave way at %1</source>
        <translation>Das Gewebe gab bei %1 nach</translation>
    </message>
    <message>
        <source>Finding %1 marked</source>
        <translation>Fund %1 markiert</translation>
    </message>
    <message>
        <source>Finding %1 taken back</source>
        <translation>Fund %1 zurückgenommen</translation>
    </message>
    <message>
        <source>The trial was done</source>
        <translation>Der Durchgang wurde zu Ende geführt</translation>
    </message>
    <message>
        <source>The trial could not be done any more</source>
        <translation>Der Durchgang war nicht mehr möglich</translation>
    </message>
    <message>
        <source>The tissue was damaged</source>
        <translation>Das Gewebe wurde geschädigt</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>The procedure was done to its end</source>
        <translation>Der Eingriff wurde zu Ende geführt</translation>
    </message>
    <message>
        <source>Time was up before the end of the procedure</source>
        <translation>Die Zeit war vor dem Ende des Eingriffs um</translation>
    </message>
    <message>
        <source>The procedure could not be done any more</source>
        <translation>Der Eingriff war nicht mehr möglich</translation>
    </message>
    <message>
        <source>The tube was held as asked</source>
        <translation>Der Schlauch wurde wie verlangt gehalten</translation>
    </message>
    <message>
        <source>Time was up before the tube was held as asked</source>
        <translation>Die Zeit war um, bevor der Schlauch wie verlangt gehalten wurde</translation>
    </message>
    <message>
        <source>The tube tore: the trial could not be done any more</source>
        <translation>Der Schlauch riss: Der Durchgang war nicht mehr möglich</translation>
    </message>
    <message>
        <source>The tube was stretched too far</source>
        <translation>Der Schlauch wurde zu weit gedehnt</translation>
    </message>
    <message>
        <source>An object was set down in the target</source>
        <translation>Ein Objekt wurde im Ziel abgelegt</translation>
    </message>
    <message>
        <source>Time was up before an object was set down in the target</source>
        <translation>Die Zeit war um, bevor ein Objekt im Ziel abgelegt wurde</translation>
    </message>
    <message>
        <source>The object was squeezed too hard</source>
        <translation>Das Objekt wurde zu fest gequetscht</translation>
    </message>
    <message>
        <source>The search was reported as done</source>
        <translation>Die Suche wurde als beendet gemeldet</translation>
    </message>
    <message>
        <source>Time was up before the search was reported as done</source>
        <translation>Die Zeit war um, bevor die Suche als beendet gemeldet wurde</translation>
    </message>
    <message>
        <source>The search could not be done any more</source>
        <translation>Die Suche war nicht mehr möglich</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>Beantwortet</translation>
    </message>
    <message>
        <source>The comparison was done</source>
        <translation>Der Vergleich wurde zu Ende geführt</translation>
    </message>
    <message>
        <source>Time was up without an answer</source>
        <translation>Die Zeit war ohne Antwort um</translation>
    </message>
    <message>
        <source>The comparison could not be done any more</source>
        <translation>Der Vergleich war nicht mehr möglich</translation>
    </message>
    <message>
        <source>The object was damaged</source>
        <translation>Das Objekt wurde beschädigt</translation>
    </message>
    <message>
        <source>Force stopped by the person, for %1</source>
        <translation>Kraft von der Person angehalten, %1 lang</translation>
    </message>
    <message>
        <source>Force stopped by the person</source>
        <translation>Kraft von der Person angehalten</translation>
    </message>
    <message>
        <source>Felt less than the tissue answered for %1, which was up to %2</source>
        <translation>%1 lang weniger gefühlt, als das Gewebe antwortete: bis zu %2</translation>
    </message>
    <message>
        <source>A miss: not on what was to be marked</source>
        <translation>Ein Fehlversuch: nicht auf dem, was zu markieren war</translation>
    </message>
    <message>
        <source>Finding %1 marked where no lump was</source>
        <translation>Fund %1 markiert, wo kein Knoten war</translation>
    </message>
    <message>
        <source>A lump was missed</source>
        <translation>Ein Knoten wurde übersehen</translation>
    </message>
    <message>
        <source>The tissue gave way to a torque of %1</source>
        <translation>Das Gewebe gab bei einem Drehmoment von %1 nach</translation>
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
    <name>RocWords</name>
    <message>
        <source>Area under the curve: %1, where 0.5 is chance and 1 is perfect. Sessions: %2 (%3). Places with a lump: %4, without: %5.</source>
        <translation>Fläche unter der Kurve: %1; 0,5 ist Zufall, 1 vollkommen. Sitzungen: %2 (%3). Stellen mit Knoten: %4, ohne: %5.</translation>
    </message>
    <message>
        <source>force felt</source>
        <translation>Kraft gefühlt</translation>
    </message>
    <message>
        <source>force shown</source>
        <translation>Kraft gezeigt</translation>
    </message>
    <message>
        <source>Hits over false alarms, from certain to a guess</source>
        <translation>Treffer über falschen Alarmen, von ganz sicher bis geraten</translation>
    </message>
    <message>
        <source>False alarm rate</source>
        <translation>Rate falscher Alarme</translation>
    </message>
    <message>
        <source>Hit rate</source>
        <translation>Trefferrate</translation>
    </message>
    <message>
        <source>chance</source>
        <translation>Zufall</translation>
    </message>
    <message>
        <source>you</source>
        <translation>Sie</translation>
    </message>
</context>
<context>
    <name>RosterWords</name>
    <message>
        <source>a quotation mark is opened here and never closed</source>
        <translation>hier beginnt ein Anführungszeichen, das nie geschlossen wird</translation>
    </message>
    <message>
        <source>too many lines, %1 at most</source>
        <translation>zu viele Zeilen, höchstens %1</translation>
    </message>
    <message>
        <source>a heading line and at least one person are needed</source>
        <translation>eine Kopfzeile und mindestens eine Person sind nötig</translation>
    </message>
    <message>
        <source>the column &quot;%1&quot; is not known, or is there twice</source>
        <translation>die Spalte „%1“ ist unbekannt oder doppelt vorhanden</translation>
    </message>
    <message>
        <source>the columns name, roles and password are needed</source>
        <translation>die Spalten name, roles und password sind nötig</translation>
    </message>
    <message>
        <source>has %1 fields instead of %2</source>
        <translation>hat %1 Felder statt %2</translation>
    </message>
    <message>
        <source>roles &quot;%1&quot;: only trainee, trainer, researcher and admin, separated by semicolons</source>
        <translation>Rollen „%1“: nur trainee, trainer, researcher und admin, durch Semikolon getrennt</translation>
    </message>
    <message>
        <source>the name &quot;%1&quot; cannot be used</source>
        <translation>der Name „%1“ ist nicht möglich</translation>
    </message>
    <message>
        <source>the full name is too long</source>
        <translation>der vollständige Name ist zu lang</translation>
    </message>
    <message>
        <source>the password needs %1 characters, %2 different ones, and must not be the name</source>
        <translation>das Passwort braucht %1 Zeichen, davon %2 verschiedene, und darf nicht der Name sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is in line %2 already</source>
        <translation>„%1“ steht schon in Zeile %2</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is on this site already</source>
        <translation>„%1“ gibt es an diesem Standort schon</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
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
        <source>My results</source>
        <translation>Meine Ergebnisse</translation>
    </message>
    <message>
        <source>Debrief</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Übungen</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Storage</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Arbeitsplatz</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Questionnaire</source>
        <translation>Fragebogen</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
</context>
<context>
    <name>SessionWords</name>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Incomplete</source>
        <translation>Unvollständig</translation>
    </message>
    <message>
        <source>Faulted</source>
        <translation>Gestört</translation>
    </message>
    <message>
        <source>Voided</source>
        <translation>Ungültig</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Does not count</source>
        <translation>Zählt nicht</translation>
    </message>
    <message>
        <source>Familiarisation</source>
        <translation>Eingewöhnung</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Gefühlt</translation>
    </message>
    <message>
        <source>Shown, not felt</source>
        <translation>Gezeigt, nicht gefühlt</translation>
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
        <translation>gerade eben</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>vor %n Minute</numerusform>
            <numerusform>vor %n Minuten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>vor %n Stunde</numerusform>
            <numerusform>vor %n Stunden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>vor %n Tag</numerusform>
            <numerusform>vor %n Tagen</numerusform>
        </translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
</context>
<context>
    <name>Sessions</name>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Incomplete</source>
        <translation>Unvollständig</translation>
    </message>
    <message>
        <source>Faulted</source>
        <translation>Gestört</translation>
    </message>
    <message>
        <source>Voided</source>
        <translation>Ungültig</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Gefühlt</translation>
    </message>
    <message>
        <source>Shown, not felt</source>
        <translation>Gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Force felt</source>
        <translation>Kraft gefühlt</translation>
    </message>
    <message>
        <source>Force shown, not felt</source>
        <translation>Kraft gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>%1 (scripted)</source>
        <translation>%1 (programmiert)</translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation>Stufe %1</translation>
    </message>
    <message>
        <source>Level %1: %2</source>
        <translation>Stufe %1: %2</translation>
    </message>
    <message>
        <source>Not counted</source>
        <translation>Zählt nicht</translation>
    </message>
    <message>
        <source>Simulated gimbal</source>
        <translation>Simulierter Gimbal</translation>
    </message>
    <message>
        <source>Mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>Recorded trace</source>
        <translation>Aufgezeichnete Bewegung</translation>
    </message>
    <message>
        <source>Simulated five-bar mechanism</source>
        <translation>Simuliertes Fünfgelenk</translation>
    </message>
    <message>
        <source>Simulated arm with fingertip platform</source>
        <translation>Simulierter Arm mit Fingerkuppen-Plattform</translation>
    </message>
    <message>
        <source>Force rendered to a scripted hand</source>
        <translation>Kraft an eine programmierte Hand ausgegeben</translation>
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
    <name>StageWords</name>
    <message>
        <source>Inspection: %1 of %2 landmarks seen. Hold still</source>
        <translation>Inspektion: %1 von %2 Landmarken gesehen. Stillhalten</translation>
    </message>
    <message>
        <source>Inspection: %1 of %2 landmarks seen</source>
        <translation>Inspektion: %1 von %2 Landmarken gesehen</translation>
    </message>
    <message>
        <source>Before the entrance</source>
        <translation>Vor der Öffnung</translation>
    </message>
    <message>
        <source>Insertion</source>
        <translation>Einführen</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Inspektion</translation>
    </message>
    <message>
        <source>Withdrawal</source>
        <translation>Rückzug</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Before the entrance: advance into the urethra</source>
        <translation>Vor der Öffnung: in die Harnröhre vorschieben</translation>
    </message>
    <message>
        <source>Insertion: %1 of %2 mm</source>
        <translation>Einführen: %1 von %2 mm</translation>
    </message>
    <message>
        <source>Insertion: on the way to the goal</source>
        <translation>Einführen: auf dem Weg zum Ziel</translation>
    </message>
    <message>
        <source>Withdrawal: bring the endoscope out again</source>
        <translation>Rückzug: das Endoskop wieder herausführen</translation>
    </message>
</context>
<context>
    <name>StationWords</name>
    <message>
        <source>Simulated mechanism with a scripted hand</source>
        <translation>Simulierter Mechanismus mit programmierter Hand</translation>
    </message>
    <message>
        <source>Mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>Recorded trace</source>
        <translation>Aufgezeichnete Bewegung</translation>
    </message>
    <message>
        <source>Ready. Nothing needs to be connected.</source>
        <translation>Bereit. Es muss nichts angeschlossen werden.</translation>
    </message>
    <message>
        <source>Ready. Moves the tool with a pointer or with keys.</source>
        <translation>Bereit. Bewegt das Instrument mit Zeiger oder Tasten.</translation>
    </message>
    <message>
        <source>Ready. Plays a trace file as if a hand moved the device.</source>
        <translation>Bereit. Spielt eine Bewegungsdatei ab, als bewegte eine Hand das Gerät.</translation>
    </message>
    <message>
        <source>Force is felt</source>
        <translation>Kraft wird gefühlt</translation>
    </message>
    <message>
        <source>Force is shown, not felt</source>
        <translation>Kraft wird gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>The force loop has real-time priority.</source>
        <translation>Die Kraftregelung läuft mit Echtzeitpriorität.</translation>
    </message>
    <message>
        <source>The force loop has no real-time priority: under load, touch may become rough.</source>
        <translation>Die Kraftregelung läuft ohne Echtzeitpriorität: Unter Last kann sich die Berührung rau anfühlen.</translation>
    </message>
    <message>
        <source>To permit it, the administrator of this computer puts two lines into a file in /etc/security/limits.d, with the name of the group that trains: &quot;@group - rtprio 80&quot; and &quot;@group - memlock unlimited&quot;. It takes effect at the next login to the computer.</source>
        <translation>Zum Erlauben trägt die Systemadministration dieses Computers zwei Zeilen in eine Datei in /etc/security/limits.d ein, mit dem Namen der Gruppe, die trainiert: „@group - rtprio 80“ und „@group - memlock unlimited“. Das gilt ab der nächsten Anmeldung am Computer.</translation>
    </message>
    <message>
        <source>Memory is locked: nothing the loop needs can be swapped out.</source>
        <translation>Der Arbeitsspeicher ist gesperrt: Nichts, was die Regelung braucht, kann ausgelagert werden.</translation>
    </message>
    <message>
        <source>Memory is not locked: under pressure the loop may have to wait for the disk.</source>
        <translation>Der Arbeitsspeicher ist nicht gesperrt: Wird er knapp, muss die Regelung womöglich auf die Festplatte warten.</translation>
    </message>
    <message>
        <source>%1 ticks of 1 ms. Half of them started within %2 µs, 99 of 100 within %3 µs, the latest after %4 µs. %5 were more than 100 µs late, %6 were left out.</source>
        <translation>%1 Takte von 1 ms. Die Hälfte begann innerhalb von %2 µs, 99 von 100 innerhalb von %3 µs, der späteste nach %4 µs. %5 kamen mehr als 100 µs zu spät, %6 fielen aus.</translation>
    </message>
    <message numerus="yes">
        <source>The loop is not punctual: %n tick(s) were left out. Close other programs, or permit real-time priority.</source>
        <translation>
            <numerusform>Die Schleife ist nicht pünktlich: %n Takt fiel aus. Schließen Sie andere Programme oder erlauben Sie Echtzeitpriorität.</numerusform>
            <numerusform>Die Schleife ist nicht pünktlich: %n Takte fielen aus. Schließen Sie andere Programme oder erlauben Sie Echtzeitpriorität.</numerusform>
        </translation>
    </message>
    <message>
        <source>The loop is punctual: %1 % of the ticks were late (limit %2 %), and none was left out.</source>
        <translation>Die Schleife ist pünktlich: %1 % der Takte kamen zu spät (Grenze %2 %), und keiner fiel aus.</translation>
    </message>
    <message>
        <source>The loop is not punctual: %1 % of the ticks were late (limit %2 %). Close other programs, or permit real-time priority.</source>
        <translation>Die Schleife ist nicht pünktlich: %1 % der Takte kamen zu spät (Grenze %2 %). Schließen Sie andere Programme oder erlauben Sie Echtzeitpriorität.</translation>
    </message>
</context>
<context>
    <name>StorageWords</name>
    <message>
        <source>The disk is full: %1 are free. Sessions may not be stored. Make room before anybody trains.</source>
        <translation>Die Festplatte ist voll: %1 sind frei. Sitzungen werden womöglich nicht gespeichert. Schaffen Sie Platz, bevor jemand trainiert.</translation>
    </message>
    <message>
        <source>There is no room for the safety copy of a running session (%1 needed, %2 free in memory). Sessions will be refused. Close other programs.</source>
        <translation>Für die Sicherheitskopie einer laufenden Sitzung fehlt Platz (%1 nötig, %2 im Arbeitsspeicher frei). Sitzungen werden abgelehnt. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>The disk is getting full: %1 are free. Sessions can still be recorded. Make room, or move backups to another disk.</source>
        <translation>Die Festplatte wird voll: %1 sind frei. Sitzungen können noch aufgezeichnet werden. Schaffen Sie Platz oder verschieben Sie Sicherungen auf eine andere Festplatte.</translation>
    </message>
    <message>
        <source>Memory for the safety copy of running sessions is getting short: %1 are free.</source>
        <translation>Der Arbeitsspeicher für die Sicherheitskopie laufender Sitzungen wird knapp: %1 sind frei.</translation>
    </message>
    <message>
        <source>There is room: %1 are free.</source>
        <translation>Es ist Platz: %1 sind frei.</translation>
    </message>
    <message>
        <source>There is no backup yet. What is recorded exists only once.</source>
        <translation>Es gibt noch keine Sicherung. Aufgezeichnetes ist nur einmal vorhanden.</translation>
    </message>
    <message>
        <source>The last backup was made %1. Make a new one.</source>
        <translation>Letzte Sicherung: %1. Erstellen Sie eine neue.</translation>
    </message>
    <message>
        <source>The last backup was made %1.</source>
        <translation>Letzte Sicherung: %1.</translation>
    </message>
    <message>
        <source>The file is damaged</source>
        <translation>Die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>A record was changed</source>
        <translation>Ein Datensatz wurde verändert</translation>
    </message>
    <message>
        <source>Recorded data was changed</source>
        <translation>Aufgezeichnete Daten wurden verändert</translation>
    </message>
    <message>
        <source>Something is missing</source>
        <translation>Etwas fehlt</translation>
    </message>
    <message>
        <source>It cannot be read</source>
        <translation>Nicht lesbar</translation>
    </message>
    <message>
        <source>A session is not as it ended</source>
        <translation>Eine Sitzung ist nicht, wie sie endete</translation>
    </message>
    <message>
        <source>The audit trail does not hold</source>
        <translation>Das Prüfprotokoll stimmt nicht</translation>
    </message>
    <message>
        <source>A score does not follow from its recording</source>
        <translation>Eine Wertung folgt nicht aus ihrer Aufzeichnung</translation>
    </message>
    <message>
        <source>Something does not hold</source>
        <translation>Etwas stimmt nicht</translation>
    </message>
    <message numerus="yes">
        <source>%n thing(s) do not hold. Nothing was changed. Keep this database as it is and restore a backup that verifies.</source>
        <translation>
            <numerusform>%n Stelle stimmt nicht. Es wurde nichts geändert. Lassen Sie diese Datenbank, wie sie ist, und stellen Sie eine geprüfte Sicherung wieder her.</numerusform>
            <numerusform>%n Stellen stimmen nicht. Es wurde nichts geändert. Lassen Sie diese Datenbank, wie sie ist, und stellen Sie eine geprüfte Sicherung wieder her.</numerusform>
        </translation>
    </message>
    <message>
        <source>The check was stopped after %1 records. Nothing wrong was found until then.</source>
        <translation>Die Prüfung wurde nach %1 Datensätzen abgebrochen. Bis dahin wurde kein Fehler gefunden.</translation>
    </message>
    <message>
        <source>Everything holds: %1 records, every recording, every score, the audit trail.</source>
        <translation>Alles stimmt: %1 Datensätze, jede Aufzeichnung, jede Wertung, das Prüfprotokoll.</translation>
    </message>
</context>
<context>
    <name>StudyData</name>
    <message>
        <source>Participant and condition</source>
        <translation>Teilnehmende Person und Bedingung</translation>
    </message>
</context>
<context>
    <name>StudyReport</name>
    <message>
        <source>Study report</source>
        <translation>Studienbericht</translation>
    </message>
    <message>
        <source>DEMONSTRATION: invented people and results</source>
        <translation>DEMONSTRATION: erfundene Personen und Ergebnisse</translation>
    </message>
    <message numerus="yes">
        <source>SIMULATED: %n participant(s) are programs, not persons</source>
        <translation>
            <numerusform>SIMULIERT: %n Teilnehmer ist ein Programm, keine Person</numerusform>
            <numerusform>SIMULIERT: %n Teilnehmer sind Programme, keine Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>BLIND: conditions go by sealed codes until the study is unblinded</source>
        <translation>VERBLINDET: Bedingungen tragen versiegelte Codes, bis die Studie entblindet ist</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Frozen on</source>
        <translation>Eingefroren am</translation>
    </message>
    <message>
        <source>Participants, planned</source>
        <translation>Teilnehmende, geplant</translation>
    </message>
    <message>
        <source>Scored trials</source>
        <translation>Gewertete Durchgänge</translation>
    </message>
    <message>
        <source>Order of conditions</source>
        <translation>Reihenfolge der Bedingungen</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Participants blind</source>
        <translation>Teilnehmende verblindet</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Experimenters blind</source>
        <translation>Versuchsleitung verblindet</translation>
    </message>
    <message>
        <source>unblinded</source>
        <translation>entblindet</translation>
    </message>
    <message>
        <source>Frozen design (SHA-256)</source>
        <translation>Eingefrorener Entwurf (SHA-256)</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Teilnehmende</translation>
    </message>
    <message>
        <source>person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Nobody takes part yet.</source>
        <translation>Noch nimmt niemand teil.</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Person or simulated</source>
        <translation>Person oder simuliert</translation>
    </message>
    <message>
        <source>Enrolled</source>
        <translation>Aufgenommen</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>Conditions done</source>
        <translation>Bedingungen erledigt</translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation>Wiedergabetreue</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Gewertet</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Wiederholt</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Why repeated</source>
        <translation>Warum wiederholt</translation>
    </message>
    <message>
        <source>Same choices again</source>
        <translation>Erneut gleiche Wahl</translation>
    </message>
    <message>
        <source>A trial is repeated when the force is off by more than %1 N, the felt value by more than %2, more than %3 of the ticks are late, or the device is at its limit in more than %4 of the contact.</source>
        <translation>Ein Durchgang wird wiederholt, wenn die Kraft um mehr als %1 N oder der gefühlte Wert um mehr als %2 abweicht, mehr als %3 der Takte verspätet sind oder das Gerät in mehr als %4 des Kontakts an seiner Grenze ist.</translation>
    </message>
    <message>
        <source>Same choices again: run again from its log, the procedure chose the same presentations.</source>
        <translation>Erneut gleiche Wahl: Aus dem Protokoll wiederholt, wählte das Verfahren dieselben Darbietungen.</translation>
    </message>
    <message>
        <source>No answers</source>
        <translation>Keine Antworten</translation>
    </message>
    <message numerus="yes">
        <source>%n free text(s), in the exported tables</source>
        <translation>
            <numerusform>%n freier Text, in den exportierten Tabellen</numerusform>
            <numerusform>%n freie Texte, in den exportierten Tabellen</numerusform>
        </translation>
    </message>
    <message>
        <source>Median %1, middle half %2 to %3, of %4</source>
        <translation>Median %1, mittlere Hälfte %2 bis %3, von %4</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Difference from the reference (%)</source>
        <translation>Unterschied zur Referenz (%)</translation>
    </message>
    <message>
        <source>Proportion right</source>
        <translation>Anteil richtig</translation>
    </message>
    <message>
        <source>95 % band</source>
        <translation>95-%-Band</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Nobody has done this condition yet.</source>
        <translation>Diese Bedingung hat noch niemand gemacht.</translation>
    </message>
    <message>
        <source>Weber fraction of the group</source>
        <translation>Weber-Bruch der Gruppe</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95-%-Intervall</translation>
    </message>
    <message>
        <source>A further participant, 95 %</source>
        <translation>Eine weitere Person, 95 %</translation>
    </message>
    <message>
        <source>Participants used, left out</source>
        <translation>Personen verwendet, ausgelassen</translation>
    </message>
    <message>
        <source>JND at the reference</source>
        <translation>JND an der Referenz</translation>
    </message>
    <message>
        <source>Point of equality</source>
        <translation>Punkt der Gleichheit</translation>
    </message>
    <message>
        <source>Exponent of the power law</source>
        <translation>Exponent des Potenzgesetzes</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Weber-Bruch (%)</translation>
    </message>
    <message>
        <source>group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Weber-Bruch</translation>
    </message>
    <message>
        <source>JND</source>
        <translation>JND</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Verformung</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viskosität</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Scheitel</translation>
    </message>
    <message>
        <source>Ranking of three</source>
        <translation>Rangfolge von dreien</translation>
    </message>
    <message>
        <source>Two intervals (2AFC)</source>
        <translation>Zwei zur Wahl (2AFC)</translation>
    </message>
    <message>
        <source>Three intervals (3AFC)</source>
        <translation>Drei zur Wahl (3AFC)</translation>
    </message>
    <message>
        <source>Odd one out of three</source>
        <translation>Eines von dreien ist anders</translation>
    </message>
    <message>
        <source>Same or different</source>
        <translation>Gleich oder verschieden</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Ja oder nein</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Magnitude estimation</source>
        <translation>Größenschätzung</translation>
    </message>
    <message>
        <source>Staircase (up–down)</source>
        <translation>Treppe (auf–ab)</translation>
    </message>
    <message>
        <source>Constant stimuli</source>
        <translation>Konstante Reize</translation>
    </message>
    <message>
        <source>Descending ranking (legacy)</source>
        <translation>Absteigende Rangfolge (alt)</translation>
    </message>
    <message>
        <source>QUEST+ for rankings</source>
        <translation>QUEST+ für Rangfolgen</translation>
    </message>
    <message>
        <source>As listed</source>
        <translation>Wie aufgeführt</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufällig</translation>
    </message>
    <message>
        <source>Latin square</source>
        <translation>Lateinisches Quadrat</translation>
    </message>
    <message>
        <source>Williams design</source>
        <translation>Williams-Plan</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Eingefroren</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Archived</source>
        <translation>Archiviert</translation>
    </message>
    <message>
        <source>Consent missing</source>
        <translation>Einwilligung fehlt</translation>
    </message>
    <message>
        <source>Takes part</source>
        <translation>Nimmt teil</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Withdrawn</source>
        <translation>Zurückgezogen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Force was not what was asked</source>
        <translation>Kraft war nicht die verlangte</translation>
    </message>
    <message>
        <source>Felt value off</source>
        <translation>Gefühlter Wert weicht ab</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Verspätete Takte</translation>
    </message>
    <message>
        <source>Device at its limit</source>
        <translation>Gerät an seiner Grenze</translation>
    </message>
    <message>
        <source>Moved too fast</source>
        <translation>Zu schnell bewegt</translation>
    </message>
    <message>
        <source>Pressed too hard</source>
        <translation>Zu fest gedrückt</translation>
    </message>
    <message>
        <source>Time was up</source>
        <translation>Zeit abgelaufen</translation>
    </message>
    <message>
        <source>Not all were touched</source>
        <translation>Nicht alle berührt</translation>
    </message>
    <message>
        <source>Spoiled by the experimenter</source>
        <translation>Von der Versuchsleitung verworfen</translation>
    </message>
    <message>
        <source>No mark yet</source>
        <translation>Noch keine Markierung</translation>
    </message>
    <message>
        <source>Marks about the true apex</source>
        <translation>Markierungen um den wahren Scheitel</translation>
    </message>
    <message>
        <source>Error in x (% of radius)</source>
        <translation>Fehler in x (% des Radius)</translation>
    </message>
    <message>
        <source>Error in y (% of radius)</source>
        <translation>Fehler in y (% des Radius)</translation>
    </message>
    <message>
        <source>radius R</source>
        <translation>Radius R</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>± 1 SD an axis</source>
        <translation>± 1 SD je Achse</translation>
    </message>
    <message>
        <source>Error in locating spheres</source>
        <translation>Fehler beim Finden der Kugeln</translation>
    </message>
    <message>
        <source>Absolute error (% of radius)</source>
        <translation>Fehlerbetrag (% des Radius)</translation>
    </message>
    <message>
        <source>mean over both axes ± SD</source>
        <translation>Mittel beider Achsen ± SD</translation>
    </message>
    <message>
        <source>published: %1 %</source>
        <translation>veröffentlicht: %1 %</translation>
    </message>
    <message>
        <source>%1 of R</source>
        <translation>%1 von R</translation>
    </message>
    <message>
        <source>%1 mm, %2</source>
        <translation>%1 mm, %2</translation>
    </message>
    <message>
        <source>Bias in x</source>
        <translation>Verschiebung in x</translation>
    </message>
    <message>
        <source>Bias in y</source>
        <translation>Verschiebung in y</translation>
    </message>
    <message>
        <source>Marks, participants</source>
        <translation>Markierungen, Teilnehmende</translation>
    </message>
    <message>
        <source>SD in x</source>
        <translation>SD in x</translation>
    </message>
    <message>
        <source>SD in y</source>
        <translation>SD in y</translation>
    </message>
    <message>
        <source>Mean absolute error ± SD</source>
        <translation>Mittlerer Fehlerbetrag ± SD</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>There is no mark to summarise.</source>
        <translation>Es gibt keine Markierung.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) have no mark and are left out.</source>
        <translation>
            <numerusform>%n Versuch ohne Markierung ist ausgelassen.</numerusform>
            <numerusform>%n Versuche ohne Markierung sind ausgelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Only %n participant(s): how people differ is hardly known.</source>
        <translation>
            <numerusform>Nur %n Person: Wie sehr sich Menschen unterscheiden, ist kaum bekannt.</numerusform>
            <numerusform>Nur %n Personen: Wie sehr sich Menschen unterscheiden, ist kaum bekannt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Some participants have fewer than 10 marks.</source>
        <translation>Manche Personen haben weniger als 10 Markierungen.</translation>
    </message>
    <message>
        <source>Errors in x lean to one side: the absolute error is not scatter alone.</source>
        <translation>Fehler in x neigen zu einer Seite: Der Fehlerbetrag ist nicht Streuung allein.</translation>
    </message>
    <message>
        <source>Errors in y lean to one side: the absolute error is not scatter alone.</source>
        <translation>Fehler in y neigen zu einer Seite: Der Fehlerbetrag ist nicht Streuung allein.</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) lie off the sphere.</source>
        <translation>
            <numerusform>%n Markierung liegt neben der Kugel.</numerusform>
            <numerusform>%n Markierungen liegen neben der Kugel.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) are of the observer for planning: nothing was rendered.</source>
        <translation>
            <numerusform>%n Markierung stammt vom Beobachter für die Planung: Nichts wurde dargestellt.</numerusform>
            <numerusform>%n Markierungen stammen vom Beobachter für die Planung: Nichts wurde dargestellt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) were set without touching anything.</source>
        <translation>
            <numerusform>%n Markierung wurde ohne Berührung gesetzt.</numerusform>
            <numerusform>%n Markierungen wurden ohne Berührung gesetzt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) who withdrew are left out.</source>
        <translation>
            <numerusform>%n Person, die zurückgetreten ist, ist ausgelassen.</numerusform>
            <numerusform>%n Personen, die zurückgetreten sind, sind ausgelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n simulated participant(s) are left out: the group is of people.</source>
        <translation>
            <numerusform>%n simulierte Person ist ausgelassen: Die Gruppe besteht aus Menschen.</numerusform>
            <numerusform>%n simulierte Personen sind ausgelassen: Die Gruppe besteht aus Menschen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The group is of simulated participants alone.</source>
        <translation>Die Gruppe besteht allein aus simulierten Personen.</translation>
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
        <translation>Bezug</translation>
    </message>
    <message>
        <source>D more</source>
        <translation>D mehr</translation>
    </message>
    <message>
        <source>2D more</source>
        <translation>2D mehr</translation>
    </message>
    <message>
        <source>Not estimable</source>
        <translation>Nicht schätzbar</translation>
    </message>
    <message>
        <source>estimate with its 95 % interval</source>
        <translation>Schätzung mit 95-%-Intervall</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Rankings</source>
        <translation>Rangfolgen</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Richtig</translation>
    </message>
    <message>
        <source>Kendall&apos;s τ</source>
        <translation>Kendalls τ</translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation>Kendalls W</translation>
    </message>
    <message>
        <source>Page&apos;s L</source>
        <translation>Pages L</translation>
    </message>
    <message>
        <source>No worth of an object is finite: some object was always, or never, ranked above the others.</source>
        <translation>Kein Wert eines Objekts ist endlich: Ein Objekt stand immer oder nie über den anderen.</translation>
    </message>
    <message>
        <source>Bradley-Terry</source>
        <translation>Bradley-Terry</translation>
    </message>
    <message>
        <source>ln worth</source>
        <translation>ln Wert</translation>
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
        <source>Scale (sd)</source>
        <translation>Skala (SD)</translation>
    </message>
    <message>
        <source>Worth of each object, of all rankings of the group: how much more often it was ranked above the others. Farther apart means easier to tell apart. All differences D are taken together.</source>
        <translation>Wert jedes Objekts aus allen Rangfolgen der Gruppe: wie viel öfter es über den anderen stand. Je weiter auseinander, desto leichter zu unterscheiden. Alle Unterschiede D sind zusammengenommen.</translation>
    </message>
    <message>
        <source>Sealed reason</source>
        <translation>Versiegelter Grund</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) could not be used: the difference or the answer is missing.</source>
        <translation>
            <numerusform>%n Durchgang ist nicht verwendbar: Unterschied oder Antwort fehlt.</numerusform>
            <numerusform>%n Durchgänge sind nicht verwendbar: Unterschied oder Antwort fehlt.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no scored trial yet, so nothing can be said.</source>
        <translation>Es gibt noch keinen gewerteten Durchgang; es lässt sich nichts sagen.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n trial(s): the interval is wide and rests partly on what was assumed beforehand.</source>
        <translation>
            <numerusform>Nur %n Durchgang: Das Intervall ist breit und beruht zum Teil auf Annahmen von vornherein.</numerusform>
            <numerusform>Nur %n Durchgänge: Das Intervall ist breit und beruht zum Teil auf Annahmen von vornherein.</numerusform>
        </translation>
    </message>
    <message>
        <source>The objects never differed, so nothing can be said about telling them apart.</source>
        <translation>Die Objekte unterschieden sich nie; darüber, wie gut sie unterschieden werden, lässt sich nichts sagen.</translation>
    </message>
    <message>
        <source>Only one difference was presented: slips of attention cannot be told from a high threshold.</source>
        <translation>Es wurde nur ein Unterschied dargeboten: Unaufmerksamkeit und eine hohe Schwelle sind nicht auseinanderzuhalten.</translation>
    </message>
    <message>
        <source>Very many different differences were presented; neighbouring ones were put together.</source>
        <translation>Es wurden sehr viele verschiedene Unterschiede dargeboten; benachbarte wurden zusammengefasst.</translation>
    </message>
    <message>
        <source>The same answer was given every time: it says nothing about what was felt.</source>
        <translation>Jedes Mal wurde dasselbe geantwortet: Das sagt nichts darüber, was gefühlt wurde.</translation>
    </message>
    <message>
        <source>Every answer was right: the threshold is below the smallest difference, how far is not known.</source>
        <translation>Jede Antwort war richtig: Die Schwelle liegt unter dem kleinsten Unterschied, wie weit, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>No better than guessing: the threshold may be above the largest difference presented.</source>
        <translation>Nicht besser als geraten: Die Schwelle liegt vielleicht über dem größten dargebotenen Unterschied.</translation>
    </message>
    <message>
        <source>More than a tenth of the answers look like guesses even where the difference was easy.</source>
        <translation>Mehr als ein Zehntel der Antworten sieht auch dort nach Raten aus, wo der Unterschied leicht war.</translation>
    </message>
    <message>
        <source>Answers jump from guessing to always right between two neighbouring differences: what lies between is not known.</source>
        <translation>Zwischen zwei benachbarten Unterschieden springen die Antworten von geraten auf immer richtig: Was dazwischen liegt, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Wrong answers fall on one place much more often than chance allows.</source>
        <translation>Falsche Antworten fallen viel öfter auf einen Platz, als der Zufall es erlaubt.</translation>
    </message>
    <message>
        <source>Conditions differ in what an analysis needs to know: there is an estimate once the study is unblinded.</source>
        <translation>Die Bedingungen unterscheiden sich in dem, was eine Auswertung wissen muss: Eine Schätzung gibt es, sobald die Studie entblindet ist.</translation>
    </message>
    <message>
        <source>A quick simulation without rendering: the observer was told the values.</source>
        <translation>Eine schnelle Simulation ohne Darstellung: Dem Beobachter wurden die Werte gesagt.</translation>
    </message>
    <message>
        <source>The answers do not tell how small the threshold is: the value shown is what was assumed beforehand.</source>
        <translation>Die Antworten sagen nicht, wie klein die Schwelle ist: Der gezeigte Wert ist die Annahme von vornherein.</translation>
    </message>
    <message>
        <source>The answers do not tell how large the threshold is: the value shown is what was assumed beforehand.</source>
        <translation>Die Antworten sagen nicht, wie groß die Schwelle ist: Der gezeigte Wert ist die Annahme von vornherein.</translation>
    </message>
    <message>
        <source>The lower end of the interval comes from what was assumed beforehand, not from the answers.</source>
        <translation>Das untere Ende des Intervalls stammt aus der Annahme von vornherein, nicht aus den Antworten.</translation>
    </message>
    <message>
        <source>The upper end of the interval comes from what was assumed beforehand, not from the answers.</source>
        <translation>Das obere Ende des Intervalls stammt aus der Annahme von vornherein, nicht aus den Antworten.</translation>
    </message>
    <message>
        <source>The curve does not describe the answers well: attention or strategy may have changed.</source>
        <translation>Die Kurve beschreibt die Antworten schlecht: Aufmerksamkeit oder Vorgehen haben sich vielleicht geändert.</translation>
    </message>
    <message>
        <source>Another curve through the same answers puts the threshold elsewhere: take the value with care.</source>
        <translation>Eine andere Kurve durch dieselben Antworten legt die Schwelle anderswohin: Der Wert ist mit Vorsicht zu nehmen.</translation>
    </message>
    <message>
        <source>Answers do not get better as the difference grows, so there is no threshold to find.</source>
        <translation>Die Antworten werden mit wachsendem Unterschied nicht besser; eine Schwelle ist nicht zu finden.</translation>
    </message>
    <message>
        <source>Answers get worse as the difference grows: do differences and answers belong together?</source>
        <translation>Die Antworten werden mit wachsendem Unterschied schlechter: Gehören Unterschiede und Antworten zusammen?</translation>
    </message>
    <message>
        <source>The condition has no reference above zero, so nothing can be given in its unit.</source>
        <translation>Die Bedingung hat keinen Bezugswert über null; in ihrer Einheit lässt sich nichts angeben.</translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) are not above zero and are left out.</source>
        <translation>
            <numerusform>%n Einstellung liegt nicht über null und ist ausgelassen.</numerusform>
            <numerusform>%n Einstellungen liegen nicht über null und sind ausgelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing has been set yet, so nothing can be said.</source>
        <translation>Es wurde noch nichts eingestellt; es lässt sich nichts sagen.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n setting(s): how much they scatter is hardly known.</source>
        <translation>
            <numerusform>Nur %n Einstellung: Wie sehr sie streuen, ist kaum bekannt.</numerusform>
            <numerusform>Nur %n Einstellungen: Wie sehr sie streuen, ist kaum bekannt.</numerusform>
        </translation>
    </message>
    <message>
        <source>All settings are the same: the step of the adjustment may be too coarse.</source>
        <translation>Alle Einstellungen sind gleich: Der Schritt beim Einstellen ist vielleicht zu grob.</translation>
    </message>
    <message numerus="yes">
        <source>%n answer(s) are not numbers above zero and are left out.</source>
        <translation>
            <numerusform>%n Antwort ist keine Zahl über null und ist ausgelassen.</numerusform>
            <numerusform>%n Antworten sind keine Zahlen über null und sind ausgelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No number has been said yet, so nothing can be said.</source>
        <translation>Es wurde noch keine Zahl genannt; es lässt sich nichts sagen.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n answer(s): the result is hardly known.</source>
        <translation>
            <numerusform>Nur %n Antwort: Das Ergebnis ist kaum bekannt.</numerusform>
            <numerusform>Nur %n Antworten: Das Ergebnis ist kaum bekannt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Only one strength was presented, so there is no exponent.</source>
        <translation>Es wurde nur eine Stärke dargeboten; einen Exponenten gibt es nicht.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n participant(s) with an exponent: how people differ is hardly known.</source>
        <translation>
            <numerusform>Nur %n Person mit Exponent: Wie sehr sich Menschen unterscheiden, ist kaum bekannt.</numerusform>
            <numerusform>Nur %n Personen mit Exponent: Wie sehr sich Menschen unterscheiden, ist kaum bekannt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) are left out: their answers give no value.</source>
        <translation>
            <numerusform>%n Person ist ausgelassen: Ihre Antworten ergeben keinen Wert.</numerusform>
            <numerusform>%n Personen sind ausgelassen: Ihre Antworten ergeben keinen Wert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody&apos;s answers give a value.</source>
        <translation>Von niemandem ergeben die Antworten einen Wert.</translation>
    </message>
    <message>
        <source>One participant is not a group: there is no interval.</source>
        <translation>Eine Person ist keine Gruppe: Es gibt kein Intervall.</translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) of the group were simulated without rendering: told the values, nothing was felt.</source>
        <translation>
            <numerusform>%n Person der Gruppe wurde ohne Darstellung simuliert: Ihr wurden die Werte gesagt, gefühlt wurde nichts.</numerusform>
            <numerusform>%n Personen der Gruppe wurden ohne Darstellung simuliert: Ihnen wurden die Werte gesagt, gefühlt wurde nichts.</numerusform>
        </translation>
    </message>
    <message>
        <source>The sphere has no radius above zero.</source>
        <translation>Die Kugel hat keinen Radius über null.</translation>
    </message>
    <message>
        <source>This condition cannot be simulated: it needs a procedure and differences.</source>
        <translation>Diese Bedingung lässt sich nicht simulieren: Sie braucht ein Verfahren und Unterschiede.</translation>
    </message>
    <message>
        <source>The largest difference is below what this observer needs.</source>
        <translation>Der größte Unterschied ist kleiner, als dieser Beobachter ihn braucht.</translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 simulated run(s) gave no value.</source>
        <translation>
            <numerusform>%n von %1 simulierten Läufen ergab keinen Wert.</numerusform>
            <numerusform>%n von %1 simulierten Läufen ergaben keinen Wert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Estimated from all answers together, right and wrong</source>
        <translation>Geschätzt aus allen Antworten zusammen, richtigen wie falschen</translation>
    </message>
    <message>
        <source>Estimated from all orders said together</source>
        <translation>Geschätzt aus allen genannten Reihenfolgen zusammen</translation>
    </message>
    <message>
        <source>Mean and spread of what was set</source>
        <translation>Mittel und Streuung des Eingestellten</translation>
    </message>
    <message>
        <source>A power law through the numbers said</source>
        <translation>Ein Potenzgesetz durch die genannten Zahlen</translation>
    </message>
    <message>
        <source>Errors of the marks</source>
        <translation>Fehler der Markierungen</translation>
    </message>
    <message>
        <source>Right: whole orders (guessing gives 1 in 6, with ties fewer). τ: likeness to the true order, 1 the same, 0 no relation. W: agreement, 0 none, 1 whole. L: trend towards the true order. Of a person each ranking is one judgement, of the group each person&apos;s mean ranks.</source>
        <translation>Richtig: ganze Rangfolgen (Raten ergibt 1 von 6, mit Gleichständen weniger). τ: Ähnlichkeit mit der wahren Rangfolge, 1 gleich, 0 kein Zusammenhang. W: Übereinstimmung, 0 keine, 1 völlig. L: Trend zur wahren Rangfolge. Bei einer Person ist jede Rangfolge ein Urteil, bei der Gruppe sind es die mittleren Ränge jeder Person.</translation>
    </message>
    <message>
        <source>Bradley-Terry, ties by Davidson</source>
        <translation>Bradley-Terry, Gleichstände nach Davidson</translation>
    </message>
    <message>
        <source>Ranking of three, with ties</source>
        <translation>Rangfolge von dreien, mit Gleichständen</translation>
    </message>
    <message>
        <source>People differ by more than the uncertainty of each: the group&apos;s figure says little about one person.</source>
        <translation>Die Personen unterscheiden sich um mehr als die Unsicherheit jeder einzelnen: Der Wert der Gruppe sagt wenig über eine einzelne Person.</translation>
    </message>
    <message>
        <source>data, with the number of trials</source>
        <translation>Daten, mit der Zahl der Durchgänge</translation>
    </message>
    <message>
        <source>fit: whole order right</source>
        <translation>Anpassung: ganze Reihenfolge richtig</translation>
    </message>
    <message>
        <source>the same observer, right of two</source>
        <translation>dieselbe Person, richtig von zweien</translation>
    </message>
    <message>
        <source>criterion of two compared</source>
        <translation>Kriterium beim Vergleich zweier</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>gefühlt</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Of all conditions together. How many trials there were is told of those who have done every condition.</source>
        <translation>Über alle Bedingungen zusammen. Wie viele Durchgänge es waren, steht bei denen, die jede Bedingung erledigt haben.</translation>
    </message>
    <message>
        <source>What came of it, how long it took and how many trials it took stay sealed until the study is unblinded.</source>
        <translation>Was dabei herauskam, wie lange es dauerte und wie viele Durchgänge es brauchte, bleibt versiegelt, bis die Studie entblindet ist.</translation>
    </message>
    <message numerus="yes">
        <source>Shown, not felt: %n trial(s) were done on a device that renders no force.</source>
        <translation>
            <numerusform>Gezeigt, nicht gefühlt: %n Durchgang lief auf einem Gerät, das keine Kraft wiedergibt.</numerusform>
            <numerusform>Gezeigt, nicht gefühlt: %n Durchgänge liefen auf einem Gerät, das keine Kraft wiedergibt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) are left out of the group: objects were shown to them, not felt.</source>
        <translation>
            <numerusform>%n teilnehmende Person zählt nicht zur Gruppe: Ihr wurden Objekte gezeigt, nicht fühlbar gemacht.</numerusform>
            <numerusform>%n Teilnehmende zählen nicht zur Gruppe: Ihnen wurden Objekte gezeigt, nicht fühlbar gemacht.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The group holds %n participant(s) to whom objects were shown, not felt.</source>
        <translation>
            <numerusform>Zur Gruppe gehört %n teilnehmende Person, der Objekte gezeigt, nicht fühlbar gemacht wurden.</numerusform>
            <numerusform>Zur Gruppe gehören %n Teilnehmende, denen Objekte gezeigt, nicht fühlbar gemacht wurden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>p, adjusted</source>
        <translation>p, angepasst</translation>
    </message>
    <message>
        <source>p, own thresholds</source>
        <translation>p, eigene Schwellen</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 zu %2</translation>
    </message>
    <message>
        <source>%1 did both</source>
        <translation>%1 mit beiden</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>Conditions compared</source>
        <translation>Bedingungen im Vergleich</translation>
    </message>
    <message>
        <source>Ratio of the Weber fractions, 1 where both are alike; of the people who did both where at least two have, else of two groups. Adjusted: for so many comparisons (Holm). Own thresholds: whether a threshold for each condition describes these people&apos;s answers better than one for both; not told of adaptive runs, whose answers chose the differences: there a fitted slope is biased, and p would be too small.</source>
        <translation>Verhältnis der Weber-Brüche, 1, wo beide gleich sind; von den Personen, die beides gemacht haben, wo es mindestens zwei sind, sonst von zwei Gruppen. Angepasst: an so viele Vergleiche (Holm). Eigene Schwellen: ob eine Schwelle je Bedingung die Antworten dieser Personen besser beschreibt als eine für beide; bei adaptiven Läufen, deren Antworten die Unterschiede bestimmten, nicht angegeben: Dort ist eine angepasste Steigung verzerrt, und p wäre zu klein.</translation>
    </message>
    <message>
        <source>Conditions are compared once the study is unblinded: a difference that is watched as it grows is no test any more.</source>
        <translation>Bedingungen werden verglichen, sobald die Studie entblindet ist: Ein Unterschied, dem man beim Wachsen zusieht, ist kein Test mehr.</translation>
    </message>
    <message>
        <source>The answers narrowed the prior to %1 of its width. Near 0 % the answers decide the result; near 100 % the prior does.</source>
        <translation>Die Antworten haben die A-priori-Verteilung auf %1 ihrer Breite eingeengt. Nahe 0 % entscheiden die Antworten über das Ergebnis, nahe 100 % die A-priori-Verteilung.</translation>
    </message>
    <message>
        <source>Each answer decided what came next, so one person&apos;s trials are not independent: they have no interval and no p.</source>
        <translation>Jede Antwort hat bestimmt, was als Nächstes kam; die Durchgänge einer Person sind deshalb nicht unabhängig: Sie haben kein Intervall und kein p.</translation>
    </message>
    <message>
        <source>W of the group, 95 % over its participants: %1</source>
        <translation>W der Gruppe, 95 % über ihre Teilnehmenden: %1</translation>
    </message>
    <message>
        <source>How much of the result was assumed beforehand: near 0 % the answers decide it, near 100 % the prior does.</source>
        <translation>Wie viel des Ergebnisses vorher angenommen wurde: Nahe 0 % entscheiden die Antworten, nahe 100 % die A-priori-Verteilung.</translation>
    </message>
    <message>
        <source>Prior&apos;s part</source>
        <translation>Anteil der A-priori-Verteilung</translation>
    </message>
    <message>
        <source>Prior&apos;s part: %1</source>
        <translation>Anteil der A-priori-Verteilung: %1</translation>
    </message>
</context>
<context>
    <name>StudyWords</name>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Noise (log10 σ)</source>
        <translation>Rauschen (log10 σ)</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>Lapses</source>
        <translation>Aussetzer</translation>
    </message>
    <message>
        <source>Guesses</source>
        <translation>Ratewahrscheinlichkeit</translation>
    </message>
    <message>
        <source>Staircase (up–down)</source>
        <translation>Treppe (auf–ab)</translation>
    </message>
    <message>
        <source>PEST</source>
        <translation>PEST</translation>
    </message>
    <message>
        <source>Constant stimuli</source>
        <translation>Konstante Reize</translation>
    </message>
    <message>
        <source>Descending ranking (legacy)</source>
        <translation>Absteigende Rangfolge (alt)</translation>
    </message>
    <message>
        <source>QUEST</source>
        <translation>QUEST</translation>
    </message>
    <message>
        <source>QUEST+</source>
        <translation>QUEST+</translation>
    </message>
    <message>
        <source>QUEST+ for rankings</source>
        <translation>QUEST+ für Rangfolgen</translation>
    </message>
    <message>
        <source>limited by the device</source>
        <translation>vom Gerät begrenzt</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Verformung</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viskosität</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Scheitel</translation>
    </message>
    <message>
        <source>Ranking of three</source>
        <translation>Rangfolge von dreien</translation>
    </message>
    <message>
        <source>Two intervals (2AFC)</source>
        <translation>Zwei zur Wahl (2AFC)</translation>
    </message>
    <message>
        <source>Three intervals (3AFC)</source>
        <translation>Drei zur Wahl (3AFC)</translation>
    </message>
    <message>
        <source>Odd one out of three</source>
        <translation>Eines von dreien ist anders</translation>
    </message>
    <message>
        <source>Same or different</source>
        <translation>Gleich oder verschieden</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Ja oder nein</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Magnitude estimation</source>
        <translation>Größenschätzung</translation>
    </message>
    <message>
        <source>Three objects that differ in equal steps are put in order.</source>
        <translation>Drei Objekte, die sich in gleichen Schritten unterscheiden, werden geordnet.</translation>
    </message>
    <message>
        <source>Which of two objects is more?</source>
        <translation>Welches von zwei Objekten ist mehr?</translation>
    </message>
    <message>
        <source>Which of three objects is more? Two are the reference.</source>
        <translation>Welches von drei Objekten ist mehr? Zwei sind die Referenz.</translation>
    </message>
    <message>
        <source>Which of three objects is unlike the other two?</source>
        <translation>Welches von drei Objekten unterscheidet sich von den beiden anderen?</translation>
    </message>
    <message>
        <source>Are two objects the same or different?</source>
        <translation>Sind zwei Objekte gleich oder verschieden?</translation>
    </message>
    <message>
        <source>Is one object more than the reference that was explored before?</source>
        <translation>Ist ein Objekt mehr als die Referenz, die zuvor erkundet wurde?</translation>
    </message>
    <message>
        <source>One object is changed until it equals the other.</source>
        <translation>Ein Objekt wird verändert, bis es dem anderen gleicht.</translation>
    </message>
    <message>
        <source>Each object is given a number.</source>
        <translation>Jedes Objekt bekommt eine Zahl.</translation>
    </message>
    <message>
        <source>firmer</source>
        <translation>fester</translation>
    </message>
    <message>
        <source>heavier</source>
        <translation>schwerer</translation>
    </message>
    <message>
        <source>slower to come back</source>
        <translation>langsamer in der Rückkehr</translation>
    </message>
    <message>
        <source>rougher</source>
        <translation>rauer</translation>
    </message>
    <message>
        <source>stickier</source>
        <translation>haftender</translation>
    </message>
    <message>
        <source>more viscous</source>
        <translation>zäher</translation>
    </message>
    <message>
        <source>higher</source>
        <translation>höher</translation>
    </message>
    <message>
        <source>Put the three in order; the one that is %1 comes last.</source>
        <translation>Ordnen Sie die drei; was %1 ist, kommt zuletzt.</translation>
    </message>
    <message>
        <source>Which one is %1?</source>
        <translation>Welches ist %1?</translation>
    </message>
    <message>
        <source>Which of the three is %1?</source>
        <translation>Welches der drei ist %1?</translation>
    </message>
    <message>
        <source>Which one is unlike the other two?</source>
        <translation>Welches unterscheidet sich von den beiden anderen?</translation>
    </message>
    <message>
        <source>Are the two the same or different?</source>
        <translation>Sind die beiden gleich oder verschieden?</translation>
    </message>
    <message>
        <source>Is it %1 than the reference?</source>
        <translation>Ist es %1 als die Referenz?</translation>
    </message>
    <message>
        <source>Change the right one until both feel the same.</source>
        <translation>Verändern Sie das rechte, bis sich beide gleich anfühlen.</translation>
    </message>
    <message>
        <source>Give what you feel a number. Any positive number is right.</source>
        <translation>Geben Sie dem, was Sie fühlen, eine Zahl. Jede positive Zahl ist richtig.</translation>
    </message>
    <message>
        <source>Harder after right answers, easier after wrong ones. Robust and easy to explain.</source>
        <translation>Schwerer nach richtigen, leichter nach falschen Antworten. Robust und leicht zu erklären.</translation>
    </message>
    <message>
        <source>Steps halve and double by a running test. For replications only.</source>
        <translation>Schritte halbieren und verdoppeln sich nach einem laufenden Test. Nur für Wiederholungen früherer Arbeiten.</translation>
    </message>
    <message>
        <source>Every difference equally often, in random order. The whole curve, with many trials.</source>
        <translation>Jeder Unterschied gleich oft, in zufälliger Folge. Die ganze Kurve, mit vielen Durchgängen.</translation>
    </message>
    <message>
        <source>The difference shrinks until an answer is wrong. Overestimates the JND by half to three times; for replications only.</source>
        <translation>Der Unterschied schrumpft, bis eine Antwort falsch ist. Überschätzt den JND um die Hälfte bis auf das Dreifache; nur für Wiederholungen früherer Arbeiten.</translation>
    </message>
    <message>
        <source>Bayesian; places each trial where the threshold probably is.</source>
        <translation>Bayesianisch; legt jeden Durchgang dorthin, wo die Schwelle wahrscheinlich ist.</translation>
    </message>
    <message>
        <source>Bayesian; chooses the trial that teaches most about threshold, slope and lapses.</source>
        <translation>Bayesianisch; wählt den Durchgang, der am meisten über Schwelle, Steigung und Aussetzer lehrt.</translation>
    </message>
    <message>
        <source>QUEST+ with an observer for rankings of three. Needs the fewest trials; the default.</source>
        <translation>QUEST+ mit einem Modell für Rangfolgen von dreien. Braucht die wenigsten Durchgänge; die Vorgabe.</translation>
    </message>
    <message>
        <source>Difference D</source>
        <translation>Unterschied D</translation>
    </message>
    <message>
        <source>Logarithm of D</source>
        <translation>Logarithmus von D</translation>
    </message>
    <message>
        <source>As listed</source>
        <translation>Wie aufgeführt</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufällig</translation>
    </message>
    <message>
        <source>Latin square</source>
        <translation>Lateinisches Quadrat</translation>
    </message>
    <message>
        <source>Williams design</source>
        <translation>Williams-Plan</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Eingefroren</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Archived</source>
        <translation>Archiviert</translation>
    </message>
    <message>
        <source>Consent missing</source>
        <translation>Einwilligung fehlt</translation>
    </message>
    <message>
        <source>Takes part</source>
        <translation>Nimmt teil</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Withdrawn</source>
        <translation>Zurückgezogen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>Force was not what was asked</source>
        <translation>Kraft war nicht die verlangte</translation>
    </message>
    <message>
        <source>Felt value off</source>
        <translation>Gefühlter Wert weicht ab</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Verspätete Takte</translation>
    </message>
    <message>
        <source>Device at its limit</source>
        <translation>Gerät an seiner Grenze</translation>
    </message>
    <message>
        <source>Moved too fast</source>
        <translation>Zu schnell bewegt</translation>
    </message>
    <message>
        <source>Pressed too hard</source>
        <translation>Zu fest gedrückt</translation>
    </message>
    <message>
        <source>Time was up</source>
        <translation>Zeit abgelaufen</translation>
    </message>
    <message>
        <source>Not all were touched</source>
        <translation>Nicht alle berührt</translation>
    </message>
    <message>
        <source>Spoiled by the experimenter</source>
        <translation>Von der Versuchsleitung verworfen</translation>
    </message>
    <message>
        <source>Change of a text</source>
        <translation>Textänderung</translation>
    </message>
    <message>
        <source>Sealed reason</source>
        <translation>Versiegelter Grund</translation>
    </message>
    <message>
        <source>Ranking of three, with ties</source>
        <translation>Rangfolge von dreien, mit Gleichständen</translation>
    </message>
    <message>
        <source>Three objects that differ in equal steps are put in order; those that feel the same may be called equal.</source>
        <translation>Drei Objekte, die sich in gleichen Schritten unterscheiden, werden geordnet; was sich gleich anfühlt, darf gleich genannt werden.</translation>
    </message>
    <message>
        <source>Put the three in order; the one that is %1 comes last. What feels the same may be called equal.</source>
        <translation>Ordnen Sie die drei; was %1 ist, kommt zuletzt. Was sich gleich anfühlt, darf gleich genannt werden.</translation>
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
        <translation>Unerfahren</translation>
    </message>
    <message>
        <source>Hesitant (draws back)</source>
        <translation>Zögerlich (zieht zurück)</translation>
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
        <source>Demonstration on the simulated five-bar mechanism (%1): shown, not felt</source>
        <translation>Vorführung am simulierten Fünfgelenk (%1): gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Advance and withdraw: wheel, W and S, or Page Up and Page Down. Turn: mouse or arrow keys. Move sideways: the same with the right button or Shift. Roll: Q and E. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Vorschieben und zurückziehen: Mausrad, W und S oder Bild auf und Bild ab. Drehen: Maus oder Pfeiltasten. Seitlich bewegen: ebenso mit rechter Taste oder Umschalt. Rollen um die eigene Achse: Q und E. Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Mark: click or Enter. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Bewegen: Maus oder Pfeiltasten. Senken und heben: Mausrad, rechte Taste und ziehen, oder Bild ab und Bild auf. Markieren: Klick oder Enter. Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Close the jaw: hold the left button or G. Open it: the same with Shift, or H. Instrument: 1 is the right one, 2 the left one. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Bewegen: Maus oder Pfeiltasten. Senken und heben: Mausrad, rechte Taste und ziehen, oder Bild ab und Bild auf. Maul schließen: linke Taste oder G halten. Öffnen: dasselbe mit Umschalt, oder H. Instrument: 1 ist das rechte, 2 das linke. Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Close the jaw: hold the left button or G. Open it: the same with Shift, or H. Instrument: 1 to 4. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Bewegen: Maus oder Pfeiltasten. Senken und heben: Mausrad, rechte Taste und ziehen, oder Bild ab und Bild auf. Maul schließen: linke Taste oder G halten. Öffnen: dasselbe mit Umschalt, oder H. Instrument: 1 bis 4. Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Close the jaw: hold the left button or G. Open it: the same with Shift, or H. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Bewegen: Maus oder Pfeiltasten. Senken und heben: Mausrad, rechte Taste und ziehen, oder Bild ab und Bild auf. Maul schließen: linke Taste oder G halten. Öffnen: dasselbe mit Umschalt, oder H. Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>You move the right instrument (1)</source>
        <translation>Sie bewegen das rechte Instrument (1)</translation>
    </message>
    <message>
        <source>You move the left instrument (2)</source>
        <translation>Sie bewegen das linke Instrument (2)</translation>
    </message>
    <message>
        <source>You move instrument %1 of %2</source>
        <translation>Sie bewegen Instrument %1 von %2</translation>
    </message>
    <message>
        <source>Demonstration on the simulated arm with fingertip platform (%1): shown, not felt</source>
        <translation>Vorführung am simulierten Arm mit Fingerkuppen-Plattform (%1): gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Press and lift: wheel, right button and drag, or Page Down and Page Up. Mark a finding: click or Enter.</source>
        <translation>Bewegen: Maus oder Pfeiltasten. Drücken und heben: Rad, rechte Taste und ziehen oder Bild ab und Bild auf. Fund markieren: Klick oder Eingabe.</translation>
    </message>
    <message>
        <source>Rate it: 1 to 5, V for the other rating, + and − for its size.</source>
        <translation>Bewerten: 1 bis 5, V für die andere Bewertung, + und − für die Größe.</translation>
    </message>
    <message>
        <source>Squeeze tissue between the jaws: open them in the air with O, lower them, close them with G.</source>
        <translation>Gewebe zwischen den Branchen drücken: in der Luft mit O öffnen, absenken, mit G schließen.</translation>
    </message>
    <message>
        <source>Next finding: N. Take it back: Delete. Nothing more to report: D.</source>
        <translation>Nächster Fund: N. Zurücknehmen: Entf. Nichts mehr zu melden: D.</translation>
    </message>
    <message>
        <source>Use the mouse there: T; a click in the scene takes it back.</source>
        <translation>Die Maus dort benutzen: T; ein Klick in die Szene holt sie zurück.</translation>
    </message>
    <message>
        <source>Other hand: H.</source>
        <translation>Andere Hand: H.</translation>
    </message>
    <message>
        <source>Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>You move the right hand (H for the left)</source>
        <translation>Sie bewegen die rechte Hand (H für die linke)</translation>
    </message>
    <message>
        <source>You move the left hand (H for the right)</source>
        <translation>Sie bewegen die linke Hand (H für die rechte)</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>This level has no pass mark. Everything below is for you to compare.</source>
        <translation>Diese Stufe hat keine Bestehensgrenze. Alles Folgende dient Ihrem Vergleich.</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Every pass mark of this level was met.</source>
        <translation>Alle Bestehensgrenzen dieser Stufe wurden erreicht.</translation>
    </message>
    <message>
        <source>Not passed yet</source>
        <translation>Noch nicht bestanden</translation>
    </message>
    <message numerus="yes">
        <source>%n pass mark(s) of this level were not met:</source>
        <translation>
            <numerusform>%n Bestehensgrenze dieser Stufe wurde nicht erreicht:</numerusform>
            <numerusform>%n Bestehensgrenzen dieser Stufe wurden nicht erreicht:</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 trials were done.</source>
        <translation>%1 von %2 Durchgängen wurden gemacht.</translation>
    </message>
    <message>
        <source>Stopped before the end</source>
        <translation>Vor dem Ende abgebrochen</translation>
    </message>
    <message>
        <source>%1 What was recorded is kept and can be played back. It does not count towards passing; try again when you are ready.</source>
        <translation>%1 Aufgezeichnetes bleibt erhalten und kann wiedergegeben werden. Es zählt nicht fürs Bestehen; versuchen Sie es erneut, wenn Sie so weit sind.</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>The program ended during this session. %1 Everything recorded until then was saved and can be played back. It does not count towards passing.</source>
        <translation>Das Programm endete während dieser Sitzung. %1 Alles bis dahin Aufgezeichnete wurde gespeichert und kann wiedergegeben werden. Es zählt nicht fürs Bestehen.</translation>
    </message>
    <message>
        <source>Incomplete recording</source>
        <translation>Unvollständige Aufzeichnung</translation>
    </message>
    <message numerus="yes">
        <source>The computer could not keep up and %n sample(s) were lost. The rest is kept and can be played back. It does not count towards passing; close other programs before the next attempt.</source>
        <translation>
            <numerusform>Der Computer kam nicht nach, und %n Messpunkt ging verloren. Der Rest bleibt erhalten und kann wiedergegeben werden. Er zählt nicht fürs Bestehen; schließen Sie vor dem nächsten Versuch andere Programme.</numerusform>
            <numerusform>Der Computer kam nicht nach, und %n Messpunkte gingen verloren. Der Rest bleibt erhalten und kann wiedergegeben werden. Er zählt nicht fürs Bestehen; schließen Sie vor dem nächsten Versuch andere Programme.</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended by a fault</source>
        <translation>Durch eine Störung beendet</translation>
    </message>
    <message>
        <source>The device or the force supervisor stopped this session to keep it safe. %1 What was recorded is kept. It does not count towards passing; check the device before the next attempt.</source>
        <translation>Das Gerät oder die Sicherheitsüberwachung hat diese Sitzung zur Sicherheit gestoppt. %1 Aufgezeichnetes bleibt erhalten. Es zählt nicht fürs Bestehen; prüfen Sie das Gerät vor dem nächsten Versuch.</translation>
    </message>
    <message>
        <source>Still running</source>
        <translation>Läuft noch</translation>
    </message>
    <message>
        <source>This session has not ended yet. Its result is here as soon as it has.</source>
        <translation>Diese Sitzung ist noch nicht beendet. Ihr Ergebnis erscheint hier, sobald sie es ist.</translation>
    </message>
    <message>
        <source>Voided</source>
        <translation>Ungültig</translation>
    </message>
    <message>
        <source>A trainer declared this session void. Recording and scores are kept; they count for nothing.</source>
        <translation>Eine ausbildende Person hat diese Sitzung für ungültig erklärt. Aufzeichnung und Wertungen bleiben erhalten; sie zählen nicht.</translation>
    </message>
    <message>
        <source>A trainer declared this session void: %1
Recording and scores are kept; they count for nothing.</source>
        <translation>Eine ausbildende Person hat diese Sitzung für ungültig erklärt: %1
Aufzeichnung und Wertungen bleiben erhalten; sie zählen nicht.</translation>
    </message>
    <message>
        <source>%1: no value (%2), but the pass mark is %3</source>
        <translation>%1: kein Wert (%2), doch die Bestehensgrenze ist %3</translation>
    </message>
    <message>
        <source>%1: %2, but the pass mark is %3 (%4 too much)</source>
        <translation>%1: %2, doch die Bestehensgrenze ist %3 (%4 zu viel)</translation>
    </message>
    <message>
        <source>%1: %2, but the pass mark is %3 (%4 too little)</source>
        <translation>%1: %2, doch die Bestehensgrenze ist %3 (%4 zu wenig)</translation>
    </message>
    <message>
        <source>Familiarisation: recorded, never counted. %1</source>
        <translation>Eingewöhnung: aufgezeichnet, nie gezählt. %1</translation>
    </message>
    <message>
        <source>The procedure was not done to its end.</source>
        <translation>Der Eingriff wurde nicht bis zum Ende durchgeführt.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AddPersonDialog</name>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Without commas. It cannot be changed later.</source>
        <translation>Ohne Kommas. Er lässt sich später nicht ändern.</translation>
    </message>
    <message>
        <source>Full name (may be left empty)</source>
        <translation>Vollständiger Name (darf leer bleiben)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>This name cannot be used: no commas, no spaces at the ends, at most %1 characters, and not a name that the program keeps for itself.</source>
        <translation>Dieser Name ist nicht möglich: keine Kommas, keine Leerzeichen am Anfang oder Ende, höchstens %1 Zeichen und kein Name, den das Programm selbst benutzt.</translation>
    </message>
    <message>
        <source>%1 was not added: somebody has this name already. Names differ by more than capital letters.</source>
        <translation>%1 wurde nicht hinzugefügt: Dieser Name ist schon vergeben. Groß- und Kleinschreibung allein unterscheidet Namen nicht.</translation>
    </message>
    <message>
        <source>%1 was not added.
%2</source>
        <translation>%1 wurde nicht hinzugefügt.
%2</translation>
    </message>
    <message>
        <source>%1 was added.</source>
        <translation>%1 wurde hinzugefügt.</translation>
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
    <name>chiron::desktop::AnswerPanel</name>
    <message>
        <source>here</source>
        <translation>hier</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Same (1)</source>
        <translation>Gleich (1)</translation>
    </message>
    <message>
        <source>Different (2)</source>
        <translation>Verschieden (2)</translation>
    </message>
    <message>
        <source>No (N)</source>
        <translation>Nein (N)</translation>
    </message>
    <message>
        <source>Yes (Y)</source>
        <translation>Ja (Y)</translation>
    </message>
    <message>
        <source>Less (−)</source>
        <translation>Weniger (−)</translation>
    </message>
    <message>
        <source>More (+)</source>
        <translation>Mehr (+)</translation>
    </message>
    <message>
        <source>They are the same (Enter)</source>
        <translation>Sie sind gleich (Enter)</translation>
    </message>
    <message>
        <source>Your number</source>
        <translation>Ihre Zahl</translation>
    </message>
    <message>
        <source>Give it (Enter)</source>
        <translation>Abgeben (Enter)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Back (⌫)</source>
        <translation>Zurück (⌫)</translation>
    </message>
    <message>
        <source>That is it (Enter)</source>
        <translation>Das ist es (Enter)</translation>
    </message>
    <message>
        <source>least</source>
        <translation>am wenigsten</translation>
    </message>
    <message>
        <source>between</source>
        <translation>dazwischen</translation>
    </message>
    <message>
        <source>most</source>
        <translation>am meisten</translation>
    </message>
    <message>
        <source>A number above nothing, please.</source>
        <translation>Bitte eine Zahl über null.</translation>
    </message>
    <message>
        <source>Equal to the last (=)</source>
        <translation>Gleich wie das letzte (=)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ApexPage</name>
    <message>
        <source>Nobody has done this condition yet. Each participant&apos;s marks will be here as soon as there is a run.</source>
        <translation>Noch hat niemand diese Bedingung durchlaufen. Die Markierungen jeder Person stehen hier, sobald es einen Durchgang gibt.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
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
        <translation>Verschiebung in %1</translation>
    </message>
    <message>
        <source>Mean absolute error</source>
        <translation>Mittlerer Fehlerbetrag</translation>
    </message>
    <message>
        <source>SD %1; published: %2</source>
        <translation>SD %1; veröffentlicht: %2</translation>
    </message>
    <message numerus="yes">
        <source>Per cent of the sphere&apos;s radius. %n mark(s)</source>
        <translation>
            <numerusform>Prozent des Kugelradius. %n Markierung</numerusform>
            <numerusform>Prozent des Kugelradius. %n Markierungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n trial(s) repeated</source>
        <translation>
            <numerusform>, %n Versuch wiederholt</numerusform>
            <numerusform>, %n Versuche wiederholt</numerusform>
        </translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Bias in x</source>
        <translation>Verschiebung in x</translation>
    </message>
    <message>
        <source>Bias in y</source>
        <translation>Verschiebung in y</translation>
    </message>
    <message>
        <source>SD in x</source>
        <translation>SD in x</translation>
    </message>
    <message>
        <source>SD in y</source>
        <translation>SD in y</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>%1 (%2 repeated)</source>
        <translation>%1 (%2 wiederholt)</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Mean error</source>
        <translation>Mittlerer Fehler</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ApexStage</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Where is the highest point?</source>
        <translation>Wo ist der höchste Punkt?</translation>
    </message>
    <message>
        <source>Here it is (Enter)</source>
        <translation>Hier ist er (Enter)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AttemptsTable</name>
    <message>
        <source>My attempts</source>
        <translation>Meine Versuche</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Level %1, familiarisation</source>
        <translation>Stufe %1, Eingewöhnung</translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation>Stufe %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::BreakPanel</name>
    <message>
        <source>Time of the break</source>
        <translation>Dauer der Pause</translation>
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
    <name>chiron::desktop::CommentPanel</name>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>No comments yet.</source>
        <translation>Noch keine Kommentare.</translation>
    </message>
    <message>
        <source>New comment</source>
        <translation>Neuer Kommentar</translation>
    </message>
    <message>
        <source>What is to be seen here?</source>
        <translation>Was ist hier zu sehen?</translation>
    </message>
    <message>
        <source>Comment at %1</source>
        <translation>Kommentar bei %1</translation>
    </message>
    <message>
        <source>You</source>
        <translation>Sie</translation>
    </message>
    <message>
        <source>Somebody else</source>
        <translation>Jemand anderes</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message>
        <source>Whole session · %1 · %2</source>
        <translation>Ganze Sitzung · %1 · %2</translation>
    </message>
    <message>
        <source>(erased)</source>
        <translation>(gelöscht)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ConditionsPage</name>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>A condition more</source>
        <translation>Eine Bedingung mehr</translation>
    </message>
    <message>
        <source>A condition less</source>
        <translation>Eine Bedingung weniger</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Was verglichen wird</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Id of a condition</source>
        <translation>Kennung einer Bedingung</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>Another attribute</source>
        <translation>Andere Eigenschaft</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Another task</source>
        <translation>Andere Aufgabe</translation>
    </message>
    <message>
        <source>Threshold at (proportion right)</source>
        <translation>Schwelle bei (Anteil richtig)</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Table of differences</source>
        <translation>Tabelle der Unterschiede</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Several are interleaved at random.</source>
        <translation>Mehrere werden zufällig verschränkt.</translation>
    </message>
    <message>
        <source>Scale of the procedure</source>
        <translation>Skala des Verfahrens</translation>
    </message>
    <message>
        <source>Interleave one more</source>
        <translation>Eines mehr verschränken</translation>
    </message>
    <message>
        <source>Remove the last</source>
        <translation>Letztes entfernen</translation>
    </message>
    <message>
        <source>A procedure less</source>
        <translation>Ein Verfahren weniger</translation>
    </message>
    <message>
        <source>A procedure more</source>
        <translation>Ein Verfahren mehr</translation>
    </message>
    <message>
        <source>Sealed conditions</source>
        <translation>Versiegelte Bedingungen</translation>
    </message>
    <message>
        <source>The study is blind: its conditions go by these codes, and what tells them apart is left out, until it is unblinded. Its author and administrators see the design.</source>
        <translation>Die Studie ist blind: Bis zur Entblindung stehen ihre Bedingungen unter diesen Codes, und was sie unterscheidet, bleibt weg. Den Entwurf sehen nur, wer ihn verfasst hat, und die Verwaltung.</translation>
    </message>
    <message>
        <source>What the conditions have in common</source>
        <translation>Was die Bedingungen gemeinsam haben</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Kandidaten</translation>
    </message>
    <message>
        <source>Differences from the reference</source>
        <translation>Unterschiede zur Referenz</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>The procedure works on</source>
        <translation>Das Verfahren arbeitet mit</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ConsentDialog</name>
    <message>
        <source>Consent of %1</source>
        <translation>Einwilligung von %1</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>I have read this and I agree</source>
        <translation>Ich habe dies gelesen und willige ein</translation>
    </message>
    <message>
        <source>The moment and the text&apos;s SHA-256 are recorded. Whoever takes part may withdraw at any time.</source>
        <translation>Festgehalten werden der Zeitpunkt und der SHA-256 des Textes. Wer teilnimmt, kann jederzeit zurücktreten.</translation>
    </message>
    <message>
        <source>Record the consent</source>
        <translation>Einwilligung festhalten</translation>
    </message>
    <message>
        <source>This study has no consent text.</source>
        <translation>Diese Studie hat keinen Einwilligungstext.</translation>
    </message>
    <message>
        <source>The consent was not recorded.
%1</source>
        <translation>Die Einwilligung wurde nicht festgehalten.
%1</translation>
    </message>
    <message>
        <source>The consent of %1 is recorded.</source>
        <translation>Die Einwilligung von %1 ist festgehalten.</translation>
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
        <translation>Weiter (Leertaste)</translation>
    </message>
    <message>
        <source>Re-arm (R)</source>
        <translation>Freigeben (R)</translation>
    </message>
    <message>
        <source>Start again …</source>
        <translation>Neu beginnen …</translation>
    </message>
    <message>
        <source>Start again from the beginning (F5). The attempt so far is kept as stopped.</source>
        <translation>Von vorn neu beginnen (F5). Der bisherige Versuch bleibt als abgebrochen erhalten.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::DebriefScreen</name>
    <message>
        <source>%1, level %2: %3</source>
        <translation>%1, Stufe %2: %3</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 · %4</source>
        <translation>%1 · %2 · %3 · %4</translation>
    </message>
    <message>
        <source>Force was shown, not felt: these scores form a series of their own and are not compared with felt ones.</source>
        <translation>Die Kraft wurde gezeigt, nicht gefühlt: Diese Wertungen bilden eine eigene Reihe und werden nicht mit gefühlten verglichen.</translation>
    </message>
    <message>
        <source>Next level</source>
        <translation>Nächste Stufe</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Worst moment</source>
        <translation>Schlechtester Moment</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Report (PDF)</source>
        <translation>Bericht (PDF)</translation>
    </message>
    <message>
        <source>Debrief</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>What this session came to.

At the top: whether it passed, and if not, which pass mark was missed and by how much. Below, the most important numbers on their scale: the pointer is the value, the line the pass mark, the band what others reached.

&quot;Worst moment&quot; opens the playback where it went wrong most. &quot;Report&quot; writes a printable PDF. The table holds every metric; choose a row to read what it means.</source>
        <translation>Was diese Sitzung ergeben hat.

Oben: ob sie bestanden ist, und wenn nicht, welche Bestehensgrenze um wie viel verfehlt wurde. Darunter die wichtigsten Zahlen auf ihrer Skala: Der Zeiger ist der Wert, die Linie die Bestehensgrenze, der Bereich das, was andere erreicht haben.

„Schlechtester Moment“ öffnet die Wiedergabe dort, wo am meisten schiefging. „Bericht“ schreibt ein druckbares PDF. Die Tabelle enthält jede Messgröße; wählen Sie eine Zeile, um zu lesen, was sie bedeutet.</translation>
    </message>
    <message>
        <source>Open the playback</source>
        <translation>Wiedergabe öffnen</translation>
    </message>
    <message>
        <source>Write the report (PDF)</source>
        <translation>Bericht schreiben (PDF)</translation>
    </message>
    <message>
        <source>Reading the scores …</source>
        <translation>Wertungen werden gelesen …</translation>
    </message>
    <message>
        <source>This session could not be opened</source>
        <translation>Diese Sitzung konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>All metrics</source>
        <translation>Alle Messgrößen</translation>
    </message>
    <message>
        <source>The recording was erased</source>
        <translation>Die Aufzeichnung wurde gelöscht</translation>
    </message>
    <message>
        <source>It was withdrawn at the person&apos;s wish. The scores above are kept; there is nothing to play back.</source>
        <translation>Sie wurde auf Wunsch der Person gelöscht. Die Wertungen oben bleiben erhalten; es gibt nichts wiederzugeben.</translation>
    </message>
    <message>
        <source>Reading the recording …</source>
        <translation>Aufzeichnung wird gelesen …</translation>
    </message>
    <message>
        <source>The recording could not be read. The scores above are as they were stored.</source>
        <translation>Die Aufzeichnung konnte nicht gelesen werden. Die Wertungen oben sind so, wie sie gespeichert wurden.</translation>
    </message>
    <message>
        <source>%1: %2 in trial %3, at %4</source>
        <translation>%1: %2 in Durchgang %3, bei %4</translation>
    </message>
    <message>
        <source>No trial was finished</source>
        <translation>Kein Durchgang wurde beendet</translation>
    </message>
    <message>
        <source>Chiron session %1.pdf</source>
        <translation>Chiron-Sitzung %1.pdf</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Bericht schreiben</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-Dokumente (*.pdf)</translation>
    </message>
    <message>
        <source>Writing the report …</source>
        <translation>Bericht wird geschrieben …</translation>
    </message>
    <message>
        <source>The report was written to %1.</source>
        <translation>Der Bericht wurde in %1 geschrieben.</translation>
    </message>
    <message>
        <source>The report could not be written.</source>
        <translation>Der Bericht konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>%1: %2, at %3</source>
        <translation>%1: %2, bei %3</translation>
    </message>
    <message>
        <source>Findings and maps could not be read from the recording. The scores above are as they were stored.</source>
        <translation>Funde und Karten ließen sich aus der Aufzeichnung nicht lesen. Die Wertung oben ist wie gespeichert.</translation>
    </message>
    <message>
        <source>Force of the tissue, and what was felt</source>
        <translation>Kraft des Gewebes und was davon gefühlt wurde</translation>
    </message>
    <message>
        <source>The session did not come to its end: these values are judged by no pass mark.</source>
        <translation>Die Sitzung kam nicht zu ihrem Ende: Diese Werte werden an keiner Bestehensgrenze gemessen.</translation>
    </message>
    <message>
        <source>No trial came to its end: there is no score.</source>
        <translation>Kein Durchgang kam zu seinem Ende: Es gibt keine Wertung.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::DeviceChooser</name>
    <message>
        <source>Mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>Ready. Force is shown, not felt.</source>
        <translation>Bereit. Kraft wird gezeigt, nicht gefühlt.</translation>
    </message>
    <message>
        <source>Demonstrate</source>
        <translation>Vorführen</translation>
    </message>
    <message>
        <source>Ready. Watch a scripted operator on the simulated gimbal.</source>
        <translation>Bereit. Eine programmierte Hand am simulierten Gimbal.</translation>
    </message>
    <message>
        <source>Replay a file</source>
        <translation>Datei abspielen</translation>
    </message>
    <message>
        <source>A recorded movement (CSV) moves the tool.</source>
        <translation>Eine aufgezeichnete Bewegung (CSV) führt das Instrument.</translation>
    </message>
    <message>
        <source>Who demonstrates</source>
        <translation>Wer führt vor</translation>
    </message>
    <message>
        <source>The session is listed as simulated and is nobody&apos;s score.</source>
        <translation>Die Sitzung gilt als simuliert und ist niemandes Wertung.</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>No file is chosen yet.</source>
        <translation>Noch keine Datei gewählt.</translation>
    </message>
    <message>
        <source>Choose a recorded movement</source>
        <translation>Aufgezeichnete Bewegung wählen</translation>
    </message>
    <message>
        <source>Traces (*.csv)</source>
        <translation>Bewegungsdateien (*.csv)</translation>
    </message>
    <message>
        <source>Reading the file …</source>
        <translation>Datei wird gelesen …</translation>
    </message>
    <message numerus="yes">
        <source>Ready: %n rows, %1 s.</source>
        <translation>
            <numerusform>Bereit: %n Zeile, %1 s.</numerusform>
            <numerusform>Bereit: %n Zeilen, %1 s.</numerusform>
        </translation>
    </message>
    <message>
        <source>This file cannot be played. Correct it or choose another.
%1</source>
        <translation>Diese Datei kann nicht abgespielt werden. Berichtigen Sie sie oder wählen Sie eine andere.
%1</translation>
    </message>
    <message>
        <source>Nobody demonstrates this exercise on this station.</source>
        <translation>An diesem Arbeitsplatz gibt es für diese Übung keine Vorführung.</translation>
    </message>
    <message>
        <source>Ready. Watch a scripted operator on the simulated five-bar mechanism.</source>
        <translation>Bereit. Eine programmierte Hand am simulierten Fünfgelenk.</translation>
    </message>
    <message>
        <source>A recorded movement (CSV, with orientation) moves the endoscope.</source>
        <translation>Eine aufgezeichnete Bewegung (CSV, mit Orientierung) führt das Endoskop.</translation>
    </message>
    <message>
        <source>A recorded movement (CSV, with the jaw) moves the instruments.</source>
        <translation>Eine aufgezeichnete Bewegung (CSV, mit Maul) führt die Instrumente.</translation>
    </message>
    <message>
        <source>How the gimbal renders force</source>
        <translation>Wie die Aufhängung Kraft ausgibt</translation>
    </message>
    <message>
        <source>Exactly</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>By the formulas as published (up to 27 % off)</source>
        <translation>Nach den veröffentlichten Formeln (bis 27 % daneben)</translation>
    </message>
    <message>
        <source>Ready. Watch a scripted operator on the simulated arm with fingertip platform.</source>
        <translation>Bereit. Sehen Sie einem Skript am simulierten Arm mit Fingerkuppen-Plattform zu.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::DifferenceTable</name>
    <message>
        <source>Smallest</source>
        <translation>Kleinster</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source>How many</source>
        <translation>Wie viele</translation>
    </message>
    <message>
        <source>On both sides of the reference</source>
        <translation>Auf beiden Seiten der Referenz</translation>
    </message>
    <message>
        <source>Or typed, in percent</source>
        <translation>Oder getippt, in Prozent</translation>
    </message>
    <message>
        <source>Make the table</source>
        <translation>Tabelle erstellen</translation>
    </message>
    <message>
        <source>Nothing to choose from yet.</source>
        <translation>Noch nichts zur Wahl.</translation>
    </message>
    <message>
        <source>%1 candidates, from %2 to %3 of the reference: %4 to %5.</source>
        <translation>%1 Kandidaten, von %2 bis %3 der Referenz: %4 bis %5.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::EnrolDialog</name>
    <message>
        <source>Enrol a participant</source>
        <translation>Teilnehmende Person aufnehmen</translation>
    </message>
    <message>
        <source>%1 of %2 planned participants are enrolled.</source>
        <translation>%1 von %2 geplanten Personen sind aufgenommen.</translation>
    </message>
    <message>
        <source>Who it is (name, number in your own list …)</source>
        <translation>Wer es ist (Name, Nummer Ihrer eigenen Liste …)</translation>
    </message>
    <message>
        <source>Kept in the key table alone, which only the study&apos;s author and administrators can open. Data and exports carry the code.</source>
        <translation>Steht nur in der Schlüsseltabelle, die allein Urheber der Studie und Administratoren öffnen können. Daten und Exporte tragen den Code.</translation>
    </message>
    <message>
        <source>Enrol</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>The participant was not enrolled.
%1</source>
        <translation>Die Person wurde nicht aufgenommen.
%1</translation>
    </message>
    <message>
        <source>The participant&apos;s code is</source>
        <translation>Der Code der Person ist</translation>
    </message>
    <message>
        <source>Write it down for the participant: it begins every sitting. Consent comes next.</source>
        <translation>Schreiben Sie ihn für die Person auf: Mit ihm beginnt jede Sitzung. Als Nächstes kommt die Einwilligung.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::EraseDialog</name>
    <message>
        <source>Erase %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>This cannot be undone. Disabling the account keeps everything and can be undone.</source>
        <translation>Das lässt sich nicht rückgängig machen. Wer das Konto nur deaktiviert, behält alles und kann es zurücknehmen.</translation>
    </message>
    <message>
        <source>Overwritten: name, code, password, comments and reasons in free text.</source>
        <translation>Überschrieben werden: Name, Code, Passwort, Kommentare und Begründungen im Freitext.</translation>
    </message>
    <message>
        <source>Kept without a name: sessions, scores, and that an erasure took place, when and why. Backups made before still hold the person until they are deleted; a restore erases the person again.</source>
        <translation>Ohne Namen bleiben: Sitzungen, Wertungen und der Vermerk, dass, wann und warum gelöscht wurde. Ältere Sicherungen enthalten die Person, bis sie selbst gelöscht werden; beim Wiederherstellen wird die Person erneut gelöscht.</translation>
    </message>
    <message>
        <source>Reason (kept)</source>
        <translation>Begründung (bleibt gespeichert)</translation>
    </message>
    <message>
        <source>Consent is withdrawn: overwrite the recordings too</source>
        <translation>Einwilligung widerrufen: auch die Aufzeichnungen überschreiben</translation>
    </message>
    <message>
        <source>Type the login name to confirm: %1</source>
        <translation>Zur Bestätigung den Anmeldenamen eingeben: %1</translation>
    </message>
    <message>
        <source>Your own password</source>
        <translation>Ihr eigenes Passwort</translation>
    </message>
    <message>
        <source>Erase for ever</source>
        <translation>Endgültig löschen</translation>
    </message>
    <message>
        <source>Nobody was erased: this is not your password.
%1</source>
        <translation>Es wurde niemand gelöscht: Das ist nicht Ihr Passwort.
%1</translation>
    </message>
    <message>
        <source>%1 is erased. Sessions and scores are kept without a name.</source>
        <translation>%1 ist gelöscht. Sitzungen und Wertungen bleiben ohne Namen erhalten.</translation>
    </message>
    <message>
        <source>%1 cannot be erased now: nobody can erase themselves, and no session may be running.</source>
        <translation>%1 kann jetzt nicht gelöscht werden: Niemand kann sich selbst löschen, und es darf keine Sitzung laufen.</translation>
    </message>
    <message>
        <source>The erasure of %1 is not complete: old copies may still lie in the file. Press the button again; it goes on where it stopped.
%2</source>
        <translation>Die Löschung von %1 ist nicht vollständig: In der Datei können noch alte Kopien liegen. Drücken Sie die Schaltfläche erneut; es geht dort weiter, wo es aufhörte.
%2</translation>
    </message>
    <message>
        <source>%1 was not erased.
%2</source>
        <translation>%1 wurde nicht gelöscht.
%2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExerciseCard</name>
    <message>
        <source>Passed, felt and shown</source>
        <translation>Bestanden, gefühlt und gezeigt</translation>
    </message>
    <message>
        <source>Passed by touch</source>
        <translation>Durch Tasten bestanden</translation>
    </message>
    <message>
        <source>Passed with shown force</source>
        <translation>Mit gezeigter Kraft bestanden</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s), not passed yet</source>
        <translation>
            <numerusform>%n Versuch, noch nicht bestanden</numerusform>
            <numerusform>%n Versuche, noch nicht bestanden</numerusform>
        </translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Level %1: %2</source>
        <translation>Stufe %1: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 · next step</source>
        <translation>%1 · nächster Schritt</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExerciseSetupScreen</name>
    <message>
        <source>What is measured</source>
        <translation>Was gemessen wird</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Familiarisation: recorded, but not counted</source>
        <translation>Eingewöhnung (zählt nicht)</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Here you see what an exercise asks for, what is measured and when it is passed.

Everything is chosen already: Start (or Enter) begins. Choose another level, or a device, if you want. Demonstrate lets you watch a scripted operator; its session is nobody&apos;s score. A file with a recorded movement can be replayed through the same exercise.

Hand and workspace says with which hand you work, how far the tool moves for your hand&apos;s movement, and where the middle of the field lies. A familiarisation is recorded, but never counted.</source>
        <translation>Hier sehen Sie, was eine Übung verlangt, was gemessen wird und wann sie bestanden ist.

Alles ist schon gewählt: „Starten“ (oder die Eingabetaste) beginnt. Wählen Sie auf Wunsch eine andere Stufe oder ein anderes Gerät. Bei „Vorführen“ sehen Sie einer programmierten Hand zu; deren Sitzung ist niemandes Wertung. Eine Datei mit einer aufgezeichneten Bewegung lässt sich durch dieselbe Übung abspielen.

„Hand und Arbeitsraum“ legt fest, mit welcher Hand Sie arbeiten, wie weit sich das Instrument bei einer Handbewegung bewegt und wo die Mitte des Feldes liegt. Eine Eingewöhnung wird aufgezeichnet, aber nie gezählt.</translation>
    </message>
    <message>
        <source>This exercise is not there</source>
        <translation>Diese Übung gibt es nicht</translation>
    </message>
    <message>
        <source>The content on this station has no exercise of that name.</source>
        <translation>Der Inhalt an diesem Arbeitsplatz enthält keine Übung dieses Namens.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Your earlier results could not be read; training works all the same.</source>
        <translation>Ihre früheren Ergebnisse konnten nicht gelesen werden; das Training geht trotzdem.</translation>
    </message>
    <message>
        <source>This level has no pass mark.</source>
        <translation>Diese Stufe hat keine Bestehensgrenze.</translation>
    </message>
    <message>
        <source>Level %1. %2</source>
        <translation>Stufe %1. %2</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Zusehen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExercisesScreen</name>
    <message>
        <source>Exercises</source>
        <translation>Übungen</translation>
    </message>
    <message>
        <source>All exercises of this site and their levels.

Each level says whether you have passed it. Choose one to see what is measured and what counts as passed, choose a device, and start.</source>
        <translation>Alle Übungen dieses Standorts und ihre Stufen.

Jede Stufe zeigt, ob Sie sie bestanden haben. Wählen Sie eine, um zu sehen, was gemessen wird und was als bestanden gilt, wählen Sie ein Gerät und beginnen Sie.</translation>
    </message>
    <message>
        <source>Loading the exercises …</source>
        <translation>Übungen werden geladen …</translation>
    </message>
    <message>
        <source>The exercises could not be loaded.</source>
        <translation>Die Übungen konnten nicht geladen werden.</translation>
    </message>
    <message>
        <source>There are no exercises</source>
        <translation>Es gibt keine Übungen</translation>
    </message>
    <message>
        <source>The content folder of this site holds none. Ask an administrator.</source>
        <translation>Der Inhaltsordner dieses Standorts enthält keine. Fragen Sie die Administration.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExperimenterPanel</name>
    <message>
        <source>Experimenter</source>
        <translation>Versuchsleitung</translation>
    </message>
    <message>
        <source>Spoil this trial</source>
        <translation>Durchgang verwerfen</translation>
    </message>
    <message>
        <source>It does not count and is presented again.</source>
        <translation>Er zählt nicht und wird noch einmal dargeboten.</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pause (Leertaste)</translation>
    </message>
    <message>
        <source>Stop …</source>
        <translation>Anhalten …</translation>
    </message>
    <message>
        <source>Condition %1 (sealed)</source>
        <translation>Bedingung %1 (versiegelt)</translation>
    </message>
    <message>
        <source>%1 of at most %2 trials</source>
        <translation>%1 von höchstens %2 Durchgängen</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n Durchgang</numerusform>
            <numerusform>%n Durchgänge</numerusform>
        </translation>
    </message>
    <message>
        <source>Practice, not scored. %1</source>
        <translation>Übung, zählt nicht. %1</translation>
    </message>
    <message>
        <source>%1, %2 repeated</source>
        <translation>%1, %2 wiederholt</translation>
    </message>
    <message>
        <source>Resume (Space)</source>
        <translation>Weiter (Leertaste)</translation>
    </message>
    <message>
        <source>The estimate stays sealed until the study is unblinded.</source>
        <translation>Die Schätzung bleibt versiegelt, bis die Studie entblindet ist.</translation>
    </message>
    <message>
        <source>The fidelity of each trial will be here.</source>
        <translation>Die Wiedergabetreue jedes Durchgangs erscheint hier.</translation>
    </message>
    <message>
        <source>Last trial: counted.</source>
        <translation>Letzter Durchgang: zählt.</translation>
    </message>
    <message>
        <source>Last trial: repeated. %1.</source>
        <translation>Letzter Durchgang: wird wiederholt. %1.</translation>
    </message>
    <message>
        <source>Peak force %1 N, mean speed %2 mm/s, %3 contacts, %4 s.</source>
        <translation>Spitzenkraft %1 N, mittlere Geschwindigkeit %2 mm/s, %3 Kontakte, %4 s.</translation>
    </message>
    <message>
        <source>Felt value off by %1, late ticks %2, at its limit %3.</source>
        <translation>Gefühlter Wert weicht um %1 ab, verspätete Takte %2, an der Grenze %3.</translation>
    </message>
    <message>
        <source>Force error %1 N.</source>
        <translation>Kraftfehler %1 N.</translation>
    </message>
    <message>
        <source>The device measures no force.</source>
        <translation>Das Gerät misst keine Kraft.</translation>
    </message>
    <message numerus="yes">
        <source>The device cannot render all differences: %n are left.</source>
        <translation>
            <numerusform>Das Gerät kann nicht alle Unterschiede wiedergeben: %n bleibt.</numerusform>
            <numerusform>Das Gerät kann nicht alle Unterschiede wiedergeben: %n bleiben.</numerusform>
        </translation>
    </message>
    <message>
        <source>The estimate will be here after the first scored trials.</source>
        <translation>Die Schätzung erscheint hier nach den ersten gewerteten Durchgängen.</translation>
    </message>
    <message>
        <source>Weber fraction %1</source>
        <translation>Weber-Bruch %1</translation>
    </message>
    <message>
        <source>Weber fraction %1 (95 %: %2)</source>
        <translation>Weber-Bruch %1 (95 %: %2)</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Weber-Bruch (%)</translation>
    </message>
    <message>
        <source>procedure %1</source>
        <translation>Verfahren %1</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Force is shown, not felt: nothing limits what is rendered.</source>
        <translation>Kraft wird gezeigt, nicht gefühlt: Nichts begrenzt die Darstellung.</translation>
    </message>
    <message>
        <source>Delay of the device, measured: %1 ms.</source>
        <translation>Verzögerung des Geräts, gemessen: %1 ms.</translation>
    </message>
    <message>
        <source>The delay of this device was never measured. %1 ms are taken, on the safe side of what it states.</source>
        <translation>Die Verzögerung dieses Geräts wurde nie gemessen. Angenommen werden %1 ms, vorsichtig nach seiner Angabe.</translation>
    </message>
    <message>
        <source>Mean speed %1 mm/s, %2 contacts, %3 s, late ticks %4. Forces stay sealed: they would tell the condition.</source>
        <translation>Mittlere Geschwindigkeit %1 mm/s, %2 Kontakte, %3 s, verspätete Takte %4. Kräfte bleiben versiegelt: Sie würden die Bedingung verraten.</translation>
    </message>
    <message>
        <source>It will not count</source>
        <translation>Zählt nicht</translation>
    </message>
    <message>
        <source>The bias will be here after the first scored trials.</source>
        <translation>Die Abweichung erscheint hier nach den ersten gewerteten Durchgängen.</translation>
    </message>
    <message>
        <source>Bias so far: %1 mm to the right, %2 mm away. Mean error %3 mm an axis.</source>
        <translation>Abweichung bisher: %1 mm nach rechts, %2 mm nach hinten. Mittlerer Fehler %3 mm je Achse.</translation>
    </message>
    <message>
        <source>marks</source>
        <translation>Markierungen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FindingsBox</name>
    <message>
        <source>Findings</source>
        <translation>Funde</translation>
    </message>
    <message>
        <source>None yet. Press where something is, then click or press Enter.</source>
        <translation>Noch keine. Drücken Sie, wo etwas ist, dann klicken oder Eingabe.</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Take the selected finding back (Delete)</source>
        <translation>Gewählten Fund zurücknehmen (Entf)</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Nothing found: end the trial (D)</source>
        <translation>Nichts gefunden: Ende (D)</translation>
    </message>
    <message>
        <source>Nothing more to report (D)</source>
        <translation>Nichts mehr (D)</translation>
    </message>
    <message>
        <source>None is selected.</source>
        <translation>Keiner ist gewählt.</translation>
    </message>
    <message>
        <source>Not said yet:
%1
Press again to end the trial without it.</source>
        <translation>Noch nicht angegeben:
%1
Noch einmal drücken, um ohne das zu beenden.</translation>
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
    <name>chiron::desktop::FormDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Working …</source>
        <translation>Bitte warten …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FreezeDialog</name>
    <message>
        <source>Freeze %1</source>
        <translation>%1 einfrieren</translation>
    </message>
    <message>
        <source>From now on the design can never be changed again, by nobody. Participants can be enrolled, each condition gets a sealed code, and every export carries this SHA-256 of the design:</source>
        <translation>Von jetzt an kann niemand den Entwurf mehr ändern. Personen können aufgenommen werden, jede Bedingung bekommt einen versiegelten Code, und jeder Export trägt diesen SHA-256 des Entwurfs:</translation>
    </message>
    <message numerus="yes">
        <source>%n condition(s)</source>
        <translation>
            <numerusform>%n Bedingung</numerusform>
            <numerusform>%n Bedingungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) planned</source>
        <translation>
            <numerusform>%n Person geplant</numerusform>
            <numerusform>%n Personen geplant</numerusform>
        </translation>
    </message>
    <message>
        <source>This cannot be undone. A study that has to be changed later is copied into a new one.</source>
        <translation>Das lässt sich nicht rückgängig machen. Soll eine Studie später anders sein, wird sie in eine neue kopiert.</translation>
    </message>
    <message>
        <source>Freeze the design</source>
        <translation>Entwurf einfrieren</translation>
    </message>
    <message>
        <source>The study was not frozen.
%1</source>
        <translation>Die Studie wurde nicht eingefroren.
%1</translation>
    </message>
    <message>
        <source>Frozen. Participants can be enrolled now.</source>
        <translation>Eingefroren. Jetzt können Personen aufgenommen werden.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::GeneralPage</name>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Participants planned</source>
        <translation>Geplante Personen</translation>
    </message>
    <message>
        <source>Number of participants</source>
        <translation>Zahl der Personen</translation>
    </message>
    <message>
        <source>Objective</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Instructions, as participants read them</source>
        <translation>Anleitung, wie Teilnehmende sie lesen</translation>
    </message>
    <message>
        <source>Consent text</source>
        <translation>Text der Einwilligung</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::GraspPanel</name>
    <message>
        <source>How much of the holding time is done</source>
        <translation>Wie viel der Haltezeit geschafft ist</translation>
    </message>
    <message>
        <source>Holding time: %p %</source>
        <translation>Haltezeit: %p %</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Quetschkraft</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Force, right</source>
        <translation>Kraft, rechts</translation>
    </message>
    <message>
        <source>Force, left</source>
        <translation>Kraft, links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>away</source>
        <translation>weg</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>jaw (°)</source>
        <translation>Maul (°)</translation>
    </message>
    <message>
        <source>%1, tip (mm)</source>
        <translation>%1, Spitze (mm)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Tension (N)</source>
        <translation>Spannung (N)</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Quetschkraft (N)</translation>
    </message>
    <message>
        <source>Force, right (N)</source>
        <translation>Kraft, rechts (N)</translation>
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
        <source>Stretched by %1 mm</source>
        <translation>Um %1 mm gedehnt</translation>
    </message>
    <message>
        <source>Pull of the load, downwards: %1 N</source>
        <translation>Zug der Last, nach unten: %1 N</translation>
    </message>
    <message>
        <source>Pull on the fold</source>
        <translation>Zug an der Falte</translation>
    </message>
    <message>
        <source>Force, instrument %1</source>
        <translation>Kraft, Instrument %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::GroupPage</name>
    <message>
        <source>Nobody has done this condition yet. Each participant&apos;s result will be here as soon as there is a run.</source>
        <translation>Diese Bedingung hat noch niemand gemacht. Das Ergebnis jeder Person steht hier, sobald es einen Lauf gibt.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message numerus="yes">
        <source>Weber fraction of %n participant(s), as random effects</source>
        <translation>
            <numerusform>Weber-Bruch von %n Person, als Zufallseffekt</numerusform>
            <numerusform>Weber-Bruch von %n Personen, als Zufallseffekte</numerusform>
        </translation>
    </message>
    <message>
        <source>95 %: %1</source>
        <translation>95 %: %1</translation>
    </message>
    <message>
        <source>a further participant: %1</source>
        <translation>eine weitere Person: %1</translation>
    </message>
    <message>
        <source>JND %1</source>
        <translation>JND %1</translation>
    </message>
    <message>
        <source>Rankings all in the true order: %1 of %2 (%3; guessing gives 16.7 %)</source>
        <translation>Rangfolgen ganz in der wahren Ordnung: %1 von %2 (%3; Raten ergibt 16,7 %)</translation>
    </message>
    <message>
        <source>Weber fraction of each participant</source>
        <translation>Weber-Bruch jeder Person</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Weber-Bruch (%)</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>No estimate yet</source>
        <translation>Noch keine Schätzung</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Weber-Bruch</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95-%-Intervall</translation>
    </message>
    <message>
        <source>JND</source>
        <translation>JND</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>versiegelt</translation>
    </message>
    <message>
        <source>%1 (%2 repeated)</source>
        <translation>%1 (%2 wiederholt)</translation>
    </message>
    <message>
        <source>too few people to say what a further one would show</source>
        <translation>zu wenige Personen, um zu sagen, was eine weitere zeigen würde</translation>
    </message>
    <message>
        <source>Rankings all in the true order: %1 of %2 (%3; guessing gives 16.7 % or less)</source>
        <translation>Rangfolgen ganz in der wahren Ordnung: %1 von %2 (%3; Raten ergibt 16,7 % oder weniger)</translation>
    </message>
    <message>
        <source>estimate with its 95 % interval</source>
        <translation>Schätzung mit 95-%-Intervall</translation>
    </message>
    <message>
        <source>Conditions compared</source>
        <translation>Bedingungen im Vergleich</translation>
    </message>
    <message>
        <source>Prior&apos;s part</source>
        <translation>Anteil der A-priori-Verteilung</translation>
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
    <name>chiron::desktop::HeadlineCard</name>
    <message>
        <source>No pass mark</source>
        <translation>Keine Bestehensgrenze</translation>
    </message>
    <message>
        <source>Pass mark %1</source>
        <translation>Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>Met: pass mark %1</source>
        <translation>Erreicht: Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>Not met: pass mark %1</source>
        <translation>Nicht erreicht: Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>Benchmark %1 (%2)</source>
        <translation>Referenz %1 (%2)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::HomeScreen</name>
    <message>
        <source>Exercises</source>
        <translation>Übungen</translation>
    </message>
    <message>
        <source>Every level is passed</source>
        <translation>Alle Stufen bestanden</translation>
    </message>
    <message>
        <source>Well done. Choose any exercise below to keep your hand in.</source>
        <translation>Sehr gut. Wählen Sie unten eine beliebige Übung, um in Übung zu bleiben.</translation>
    </message>
    <message>
        <source>Go on where you were</source>
        <translation>Weitermachen, wo Sie waren</translation>
    </message>
    <message>
        <source>Your next step</source>
        <translation>Ihr nächster Schritt</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>My progress</source>
        <translation>Mein Fortschritt</translation>
    </message>
    <message>
        <source>Nothing is recorded yet. Your first session will be here as soon as it has ended.</source>
        <translation>Noch nichts aufgezeichnet. Ihre erste Sitzung erscheint hier, sobald sie beendet ist.</translation>
    </message>
    <message>
        <source>All my results</source>
        <translation>Alle meine Ergebnisse</translation>
    </message>
    <message>
        <source>Sessions to look at</source>
        <translation>Sitzungen zum Ansehen</translation>
    </message>
    <message>
        <source>Nobody has trained yet. Sessions of trainees will be here, those that broke off first.</source>
        <translation>Noch niemand hat trainiert. Hier erscheinen die Sitzungen der Lernenden, abgebrochene zuerst.</translation>
    </message>
    <message>
        <source>All sessions</source>
        <translation>Alle Sitzungen</translation>
    </message>
    <message>
        <source>Who trained lately</source>
        <translation>Wer zuletzt trainiert hat</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) in the last 7 days</source>
        <translation>
            <numerusform>%n Sitzung in den letzten 7 Tagen</numerusform>
            <numerusform>%n Sitzungen in den letzten 7 Tagen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. %2. Opens the sessions.</source>
        <translation>%1. %2. Öffnet die Sitzungen.</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Every recorded session, by code instead of by name: filter the list, play sessions back, save the list as a table.</source>
        <translation>Jede aufgezeichnete Sitzung, mit Code statt Namen: Liste filtern, Sitzungen wiedergeben, Liste als Tabelle speichern.</translation>
    </message>
    <message>
        <source>Open the data</source>
        <translation>Daten öffnen</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message numerus="yes">
        <source>%n account(s) can log in.</source>
        <translation>
            <numerusform>%n Person kann sich anmelden.</numerusform>
            <numerusform>%n Personen können sich anmelden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Open people</source>
        <translation>Personen öffnen</translation>
    </message>
    <message>
        <source>Storage</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>The database takes %1; %2 are free.</source>
        <translation>Die Datenbank belegt %1; %2 sind frei.</translation>
    </message>
    <message>
        <source>Open storage</source>
        <translation>Speicher öffnen</translation>
    </message>
    <message>
        <source>The last session ran with real-time priority.</source>
        <translation>Die letzte Sitzung lief mit Echtzeitpriorität.</translation>
    </message>
    <message>
        <source>The last session ran without real-time priority: touch may be less smooth than it could be.</source>
        <translation>Die letzte Sitzung lief ohne Echtzeitpriorität: Die Berührung fühlt sich womöglich weniger glatt an als möglich.</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Arbeitsplatz</translation>
    </message>
    <message>
        <source>Devices, punctuality of the force loop, room for recordings.</source>
        <translation>Geräte, Pünktlichkeit der Kraftregelung, Platz für Aufzeichnungen.</translation>
    </message>
    <message>
        <source>Open the station check</source>
        <translation>Arbeitsplatzprüfung öffnen</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>What is next for you, by what you are here for.

Trainees continue with the next level by one button, choose any level from the exercises, and see their latest results. Trainers see the sessions that ask to be looked at, those that broke off or were not passed first, and who trained lately. Administrators see whether people, storage and station are in order.

The list on the left leads everywhere else; Ctrl+K finds any command by its name.</source>
        <translation>Was für Sie als Nächstes ansteht, je nach Ihrer Aufgabe.

Lernende machen mit einer Schaltfläche bei der nächsten Stufe weiter, wählen eine beliebige Stufe aus den Übungen und sehen ihre letzten Ergebnisse. Ausbildende sehen die Sitzungen, die einen Blick brauchen, abgebrochene oder nicht bestandene zuerst, und wer zuletzt trainiert hat. Die Administration sieht, ob Personen, Speicher und Arbeitsplatz in Ordnung sind.

Die Liste links führt überall sonst hin; Strg+K findet jeden Befehl nach seinem Namen.</translation>
    </message>
    <message>
        <source>Looking what is next …</source>
        <translation>Nächster Schritt wird gesucht …</translation>
    </message>
    <message>
        <source>The home screen could not be put together.</source>
        <translation>Die Startansicht konnte nicht aufgebaut werden.</translation>
    </message>
    <message>
        <source>Welcome, %1</source>
        <translation>Willkommen, %1</translation>
    </message>
    <message numerus="yes">
        <source>The program ended unexpectedly during session %1 (%2, %3). It was brought in as interrupted: %n sample(s) are kept and can be played back. It does not count.</source>
        <translation>
            <numerusform>Das Programm endete unerwartet während Sitzung %1 (%2, %3). Sie wurde als unterbrochen übernommen: %n Messpunkt ist erhalten und kann wiedergegeben werden. Sie zählt nicht.</numerusform>
            <numerusform>Das Programm endete unerwartet während Sitzung %1 (%2, %3). Sie wurde als unterbrochen übernommen: %n Messpunkte sind erhalten und können wiedergegeben werden. Sie zählt nicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>The program ended unexpectedly during session %1 (%2, %3), and not all of it could be brought in: %4</source>
        <translation>Das Programm endete unerwartet während Sitzung %1 (%2, %3), und sie konnte nicht ganz übernommen werden: %4</translation>
    </message>
    <message>
        <source>Look at it</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>%1, level %2: %3</source>
        <translation>%1, Stufe %2: %3</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Design a study or begin with a template, try it with simulated observers, freeze it, enrol participants.</source>
        <translation>Eine Studie entwerfen oder mit einer Vorlage beginnen, mit simulierten Beobachtern erproben, einfrieren, Personen aufnehmen.</translation>
    </message>
    <message>
        <source>Open the studies</source>
        <translation>Studien öffnen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Take a participant through a study, by code and in their own order. What was interrupted goes on where it stopped.</source>
        <translation>Eine Person durch eine Studie führen, nach Code und in ihrer eigenen Reihenfolge. Unterbrochenes geht weiter, wo es aufhörte.</translation>
    </message>
    <message>
        <source>Run a study</source>
        <translation>Studie durchführen</translation>
    </message>
    <message>
        <source>Curves, thresholds and intervals of each person and the group, every trial with its fidelity, exports.</source>
        <translation>Kurven, Schwellen und Intervalle jeder Person und der Gruppe, jeder Durchgang mit seiner Wiedergabetreue, Exporte.</translation>
    </message>
    <message>
        <source>Training sessions</source>
        <translation>Trainingssitzungen</translation>
    </message>
    <message>
        <source>Open the sessions</source>
        <translation>Sitzungen öffnen</translation>
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
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Geschwindigkeit (mm/s)</translation>
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
    <message>
        <source>Tip of the tool (mm)</source>
        <translation>Instrumentenspitze (mm)</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>away</source>
        <translation>weg</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::InsertionPanel</name>
    <message>
        <source>How much of this stage is done</source>
        <translation>Fortschritt in dieser Phase</translation>
    </message>
    <message>
        <source>Resistance along</source>
        <translation>Widerstand längs</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>Querkraft</translation>
    </message>
    <message>
        <source>Fx</source>
        <translation>Fx</translation>
    </message>
    <message>
        <source>Force along x, to the side</source>
        <translation>Kraft entlang x, zur Seite</translation>
    </message>
    <message>
        <source>Fy</source>
        <translation>Fy</translation>
    </message>
    <message>
        <source>Force along y, upwards</source>
        <translation>Kraft entlang y, nach oben</translation>
    </message>
    <message>
        <source>Fz</source>
        <translation>Fz</translation>
    </message>
    <message>
        <source>Force along z, into the patient</source>
        <translation>Kraft entlang z, in den Körper hinein</translation>
    </message>
    <message>
        <source>Tx</source>
        <translation>Tx</translation>
    </message>
    <message>
        <source>Torque about x</source>
        <translation>Drehmoment um x</translation>
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
        <translation>Drehmoment um y</translation>
    </message>
    <message>
        <source>Tz</source>
        <translation>Tz</translation>
    </message>
    <message>
        <source>Torque about the endoscope&apos;s axis</source>
        <translation>Drehmoment um die Achse des Endoskops</translation>
    </message>
    <message>
        <source>Tip x (mm)</source>
        <translation>Spitze x (mm)</translation>
    </message>
    <message>
        <source>Tip y (mm)</source>
        <translation>Spitze y (mm)</translation>
    </message>
    <message>
        <source>Tip z (mm)</source>
        <translation>Spitze z (mm)</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>Off-centre (mm)</source>
        <translation>Auslenkung (mm)</translation>
    </message>
    <message>
        <source>Alignment (°)</source>
        <translation>Ausrichtung (°)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Force across (N)</source>
        <translation>Querkraft (N)</translation>
    </message>
    <message>
        <source>Forces (N) and torques (mN·m) on the endoscope</source>
        <translation>Kräfte (N) und Drehmomente (mN·m) am Endoskop</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::KeyTableDialog</name>
    <message>
        <source>Who is who</source>
        <translation>Wer ist wer</translation>
    </message>
    <message>
        <source>That you looked is written into the audit trail.</source>
        <translation>Dass Sie nachgesehen haben, steht im Prüfprotokoll.</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Who it is</source>
        <translation>Wer es ist</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Reading the key table …</source>
        <translation>Schlüsseltabelle wird gelesen …</translation>
    </message>
    <message>
        <source>The key table could not be read</source>
        <translation>Die Schlüsseltabelle konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>The key table is empty</source>
        <translation>Die Schlüsseltabelle ist leer</translation>
    </message>
    <message>
        <source>Simulated participants have no key.</source>
        <translation>Simulierte Personen haben keinen Schlüssel.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LatenessChart</name>
    <message>
        <source>Lateness of the force loop</source>
        <translation>Verspätung der Kraftregelung</translation>
    </message>
    <message>
        <source>over %1 µs</source>
        <translation>über %1 µs</translation>
    </message>
    <message>
        <source>up to %1 µs</source>
        <translation>bis %1 µs</translation>
    </message>
    <message>
        <source>%1 %, late</source>
        <translation>%1 %, verspätet</translation>
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
        <source>Lean of the fingertip&apos;s platform</source>
        <translation>Neigung der Fingerkuppen-Plattform</translation>
    </message>
    <message>
        <source>%1°, at its limit</source>
        <translation>%1°, an der Grenze</translation>
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
        <source>Lean</source>
        <translation>Neigung</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LevelChooser</name>
    <message>
        <source>Level %1: %2</source>
        <translation>Stufe %1: %2</translation>
    </message>
    <message>
        <source>Not tried yet</source>
        <translation>Noch nicht versucht</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message numerus="yes">
        <source>Tried %n times, not passed yet</source>
        <translation>
            <numerusform>%n-mal versucht, noch nicht bestanden</numerusform>
            <numerusform>%n-mal versucht, noch nicht bestanden</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · recommended next</source>
        <translation>%1 · als Nächstes empfohlen</translation>
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
    <name>chiron::desktop::MarkList</name>
    <message>
        <source>Penalties only</source>
        <translation>Nur Abzüge</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Nothing of this kind happened.</source>
        <translation>Nichts dergleichen ist vorgekommen.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Contacts too</source>
        <translation>Auch Kontakte</translation>
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
    <name>chiron::desktop::MetricsTable</name>
    <message>
        <source>All metrics</source>
        <translation>Alle Messgrößen</translation>
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
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Choose a row to read what it means.</source>
        <translation>Wählen Sie eine Zeile, um zu lesen, was sie bedeutet.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Met</source>
        <translation>Erreicht</translation>
    </message>
    <message>
        <source>Not met</source>
        <translation>Nicht erreicht</translation>
    </message>
    <message>
        <source>Benchmark, chance</source>
        <translation>Referenz, Zufall</translation>
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
    <name>chiron::desktop::NewStudyDialog</name>
    <message>
        <source>New study</source>
        <translation>Neue Studie</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>Beginnen mit</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Key (in files and commands)</source>
        <translation>Kennung (in Dateien und Befehlen)</translation>
    </message>
    <message>
        <source>Lower-case letters, digits and _ only. It cannot be changed later.</source>
        <translation>Nur Kleinbuchstaben, Ziffern und _. Sie kann später nicht geändert werden.</translation>
    </message>
    <message>
        <source>Make the draft</source>
        <translation>Entwurf anlegen</translation>
    </message>
    <message>
        <source>The templates could not be read.
%1</source>
        <translation>Die Vorlagen konnten nicht gelesen werden.
%1</translation>
    </message>
    <message>
        <source>A plain study</source>
        <translation>Eine schlichte Studie</translation>
    </message>
    <message>
        <source>One condition, a ranking of three by stiffness.</source>
        <translation>Eine Bedingung, eine Rangfolge von dreien nach Steifigkeit.</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>The study was not made: perhaps its key is taken.
%1</source>
        <translation>Die Studie wurde nicht angelegt: vielleicht ist ihre Kennung vergeben.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PalpationBox</name>
    <message>
        <source>Trial</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>Durchgang %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PalpationPanel</name>
    <message>
        <source>%1: force</source>
        <translation>%1: Kraft</translation>
    </message>
    <message>
        <source>%1: squeeze of the jaw</source>
        <translation>%1: Druck der Branchen</translation>
    </message>
    <message>
        <source>Squeeze of the jaw</source>
        <translation>Druck der Branchen</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Map: how hard (M)</source>
        <translation>Karte: wie fest (M)</translation>
    </message>
    <message>
        <source>On: the map on the tissue shows how hard was pressed. Off: where was searched.</source>
        <translation>An: Die Karte zeigt, wie fest gedrückt wurde. Aus: wo gesucht wurde.</translation>
    </message>
    <message>
        <source>displayed force (N)</source>
        <translation>gezeigte Kraft (N)</translation>
    </message>
    <message>
        <source>lean (°)</source>
        <translation>Neigung (°)</translation>
    </message>
    <message>
        <source>depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Force, first finger (N)</source>
        <translation>Kraft, erster Finger (N)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Lean, first finger (°)</source>
        <translation>Neigung, erster Finger (°)</translation>
    </message>
    <message>
        <source>Lean (°)</source>
        <translation>Neigung (°)</translation>
    </message>
    <message>
        <source>Searched: %1 %</source>
        <translation>Abgetastet: %1 %</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ParticipantsPage</name>
    <message>
        <source>Participants can be enrolled once the design is frozen.</source>
        <translation>Personen können aufgenommen werden, sobald der Entwurf eingefroren ist.</translation>
    </message>
    <message>
        <source>Nobody is enrolled yet. Each participant gets a random code; who it is stays in a key table of its own.</source>
        <translation>Noch ist niemand aufgenommen. Jede Person bekommt einen zufälligen Code; wer sie ist, bleibt in einer eigenen Schlüsseltabelle.</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Teilnehmende</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Folge</translation>
    </message>
    <message>
        <source>Enrolled</source>
        <translation>Aufgenommen</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>Enrol …</source>
        <translation>Aufnehmen …</translation>
    </message>
    <message>
        <source>Consent …</source>
        <translation>Einwilligung …</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Withdraw …</source>
        <translation>Zurückziehen …</translation>
    </message>
    <message>
        <source>Who is who …</source>
        <translation>Wer ist wer …</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>%1 von %2 fertig</translation>
    </message>
    <message>
        <source>%1, one open</source>
        <translation>%1, eine offen</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1 (simuliert)</translation>
    </message>
    <message>
        <source>Choose a participant in the list first.</source>
        <translation>Wählen Sie zuerst jemanden in der Liste.</translation>
    </message>
    <message>
        <source>This participant is simulated.</source>
        <translation>Diese Person ist simuliert.</translation>
    </message>
    <message>
        <source>This participant has withdrawn.</source>
        <translation>Diese Person nimmt nicht mehr teil.</translation>
    </message>
    <message>
        <source>This participant has done every run.</source>
        <translation>Diese Person hat alle Läufe erledigt.</translation>
    </message>
    <message>
        <source>Participants are enrolled while a study is frozen, neither before nor after.</source>
        <translation>Aufgenommen wird, solange eine Studie eingefroren ist, weder vorher noch nachher.</translation>
    </message>
    <message>
        <source>The consent is recorded already.</source>
        <translation>Die Einwilligung ist schon festgehalten.</translation>
    </message>
    <message>
        <source>The consent has to be recorded first.</source>
        <translation>Zuerst muss die Einwilligung festgehalten werden.</translation>
    </message>
    <message>
        <source>Nobody is enrolled yet.</source>
        <translation>Es ist noch niemand aufgenommen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PasswordChoice</name>
    <message>
        <source>First password</source>
        <translation>Erstes Passwort</translation>
    </message>
    <message>
        <source>Make one up (shown once)</source>
        <translation>Erzeugen (wird einmal gezeigt)</translation>
    </message>
    <message>
        <source>Type one</source>
        <translation>Selbst eingeben</translation>
    </message>
    <message>
        <source>It has to be changed at the next login, so that only its owner knows it.</source>
        <translation>Es muss bei der nächsten Anmeldung geändert werden, damit nur die Person selbst es kennt.</translation>
    </message>
    <message>
        <source>Hand this password to %1. It is shown only now and has to be changed at the next login.</source>
        <translation>Geben Sie dieses Passwort an %1 weiter. Es wird nur jetzt gezeigt und muss bei der nächsten Anmeldung geändert werden.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
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
    <name>chiron::desktop::PeopleModel</name>
    <message>
        <source>Disabled</source>
        <translation>Deaktiviert</translation>
    </message>
    <message>
        <source>Must change the password</source>
        <translation>Muss das Passwort ändern</translation>
    </message>
    <message>
        <source>Can log in</source>
        <translation>Kann sich anmelden</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Full name</source>
        <translation>Vollständiger Name</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Account</source>
        <translation>Konto</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PeopleScreen</name>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>Import roster</source>
        <translation>Liste importieren</translation>
    </message>
    <message>
        <source>Find a person</source>
        <translation>Person suchen</translation>
    </message>
    <message>
        <source>Choose a person in the list first.</source>
        <translation>Wählen Sie zuerst eine Person in der Liste.</translation>
    </message>
    <message>
        <source>Change roles</source>
        <translation>Rollen ändern</translation>
    </message>
    <message>
        <source>Reset password</source>
        <translation>Passwort zurücksetzen</translation>
    </message>
    <message>
        <source>Disable or enable</source>
        <translation>Deaktivieren oder aktivieren</translation>
    </message>
    <message>
        <source>Export everything held</source>
        <translation>Alle Daten exportieren</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>%1 can log in again.</source>
        <translation>%1 kann sich wieder anmelden.</translation>
    </message>
    <message>
        <source>%1 can no longer log in. What was recorded is kept.</source>
        <translation>%1 kann sich nicht mehr anmelden. Aufgezeichnetes bleibt erhalten.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>%1 stays enabled: a site needs an administrator who can log in. Make another person an administrator first.</source>
        <translation>%1 bleibt aktiviert: Ein Standort braucht eine Administration, die sich anmelden kann. Geben Sie zuerst einer anderen Person diese Rolle.</translation>
    </message>
    <message>
        <source>The account of %1 is as it was.</source>
        <translation>Das Konto von %1 ist unverändert.</translation>
    </message>
    <message>
        <source>Export everything held about %1</source>
        <translation>Alle Daten über %1 exportieren</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>Everything held about %1 is in %2.</source>
        <translation>Alle Daten über %1 stehen in %2.</translation>
    </message>
    <message>
        <source>Nothing was exported about %1.</source>
        <translation>Über %1 wurde nichts exportiert.</translation>
    </message>
    <message>
        <source>Import people from a CSV file</source>
        <translation>Personen aus einer CSV-Datei importieren</translation>
    </message>
    <message>
        <source>CSV (*.csv);;All files (*)</source>
        <translation>CSV (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 cannot be read, or is too large for a list of people. Nothing was changed.</source>
        <translation>%1 ist nicht lesbar oder zu groß für eine Personenliste. Es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Everybody who has an account on this site.

Choose a person in the list, then an action below it. Changing roles and disabling take effect at once and can be undone. A new password has to be changed by its owner at the next login.

&quot;Import roster&quot; reads a CSV file with the columns name, display_name, roles and password, and shows first what it would do: everybody in it is added, or nobody.

&quot;Export&quot; writes everything that is held about a person to one file. &quot;Erase&quot; overwrites who the person was, for ever.</source>
        <translation>Alle, die an diesem Standort ein Konto haben.

Wählen Sie eine Person in der Liste, dann darunter eine Aktion. Rollen ändern und Deaktivieren wirken sofort und lassen sich rückgängig machen. Ein neues Passwort muss die Person bei der nächsten Anmeldung ändern.

„Liste importieren“ liest eine CSV-Datei mit den Spalten name, display_name, roles und password und zeigt zuerst, was geschehen würde: Alle darin werden hinzugefügt oder niemand.

„Exportieren“ schreibt alle Daten über eine Person in eine Datei. „Löschen“ überschreibt endgültig, wer die Person war.</translation>
    </message>
    <message>
        <source>Reading the people …</source>
        <translation>Personen werden gelesen …</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>Deaktivieren</translation>
    </message>
    <message>
        <source>The people could not be read.</source>
        <translation>Die Personen konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Nobody is chosen</source>
        <translation>Niemand ausgewählt</translation>
    </message>
    <message>
        <source>Choose a person in the list to change or export something.</source>
        <translation>Wählen Sie eine Person in der Liste, um etwas zu ändern oder zu exportieren.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Code %1: what researchers see in the place of the name.</source>
        <translation>Code %1: Das sehen Forschende anstelle des Namens.</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>Aktivieren</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PersonPage</name>
    <message>
        <source>There are no runs yet.</source>
        <translation>Es gibt noch keine Läufe.</translation>
    </message>
    <message>
        <source>no interval</source>
        <translation>kein Intervall</translation>
    </message>
    <message>
        <source>95 %: %1</source>
        <translation>95 %: %1</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Weber-Bruch</translation>
    </message>
    <message>
        <source>JND at the reference</source>
        <translation>JND an der Referenz</translation>
    </message>
    <message>
        <source>Point of equality</source>
        <translation>Punkt der Gleichheit</translation>
    </message>
    <message>
        <source>Internal noise, log10</source>
        <translation>Inneres Rauschen, log10</translation>
    </message>
    <message>
        <source>%1. %2. %3 scored trials, %4 repeated. %5</source>
        <translation>%1. %2. %3 gewertete Durchgänge, %4 wiederholt. %5</translation>
    </message>
    <message numerus="yes">
        <source>Run again from its log, the procedure makes the same %n choice(s).</source>
        <translation>
            <numerusform>Aus dem Protokoll wiederholt, trifft das Verfahren dieselbe %n Wahl.</numerusform>
            <numerusform>Aus dem Protokoll wiederholt, trifft das Verfahren dieselben %n Wahlen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Run again from its log, the procedure chooses differently: %1 of %2 are the same.</source>
        <translation>Aus dem Protokoll wiederholt, wählt das Verfahren anders: %1 von %2 sind gleich.</translation>
    </message>
    <message>
        <source>Right answers by difference</source>
        <translation>Richtige Antworten nach Unterschied</translation>
    </message>
    <message>
        <source>This task has no curve of right answers</source>
        <translation>Diese Aufgabe hat keine Kurve richtiger Antworten</translation>
    </message>
    <message>
        <source>Called equal below, in σ</source>
        <translation>Gleich genannt unter, in σ</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlacesView</name>
    <message>
        <source>Objects to explore</source>
        <translation>Objekte zum Erkunden</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlatformCard</name>
    <message>
        <source>Fingertip platform</source>
        <translation>Fingerkuppen-Plattform</translation>
    </message>
    <message>
        <source>Verification of the simulated platform: the published sine and orientations, steps of force, and the most that the pad gets, on eight simulated fingers.</source>
        <translation>Prüfung der simulierten Plattform: die veröffentlichte Sinusschwingung und Neigungen, Kraftsprünge und die größte Kraft an der Fingerkuppe, an acht simulierten Fingern.</translation>
    </message>
    <message>
        <source>An administrator can run it here.</source>
        <translation>Die Administration kann sie hier starten.</translation>
    </message>
    <message>
        <source>Verify the platform</source>
        <translation>Plattform prüfen</translation>
    </message>
    <message>
        <source>Record (PDF) …</source>
        <translation>Protokoll (PDF) …</translation>
    </message>
    <message>
        <source>The verification was stopped before its end.</source>
        <translation>Die Prüfung wurde vor dem Ende abgebrochen.</translation>
    </message>
    <message>
        <source>The verification could not be done: %1</source>
        <translation>Die Prüfung war nicht möglich: %1</translation>
    </message>
    <message>
        <source>Verification of the simulated fingertip platform</source>
        <translation>Prüfung der simulierten Fingerkuppen-Plattform</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlaybackPlots</name>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Geschwindigkeit (mm/s)</translation>
    </message>
    <message>
        <source>Off-centre (mm)</source>
        <translation>Auslenkung (mm)</translation>
    </message>
    <message>
        <source>Alignment (°)</source>
        <translation>Ausrichtung (°)</translation>
    </message>
    <message>
        <source>Tension of the tube</source>
        <translation>Spannung des Schlauchs</translation>
    </message>
    <message>
        <source>Squeeze of the jaws</source>
        <translation>Quetschkraft des Mauls</translation>
    </message>
    <message>
        <source>band, from</source>
        <translation>Bereich, ab</translation>
    </message>
    <message>
        <source>band, to</source>
        <translation>Bereich, bis</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>über der Grenze</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>squeeze</source>
        <translation>Quetschkraft</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Tension (N), dashed: the band asked for</source>
        <translation>Spannung (N), gestrichelt: der verlangte Bereich</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Quetschkraft (N)</translation>
    </message>
    <message>
        <source>Energy that the hand put in and that the object holds</source>
        <translation>Energie, die die Hand hineingab und die das Objekt enthält</translation>
    </message>
    <message>
        <source>more held than put in</source>
        <translation>mehr enthalten als hineingegeben</translation>
    </message>
    <message>
        <source>put in</source>
        <translation>hineingegeben</translation>
    </message>
    <message>
        <source>held</source>
        <translation>enthalten</translation>
    </message>
    <message>
        <source>Energy (mJ)</source>
        <translation>Energie (mJ)</translation>
    </message>
    <message>
        <source>finger %1</source>
        <translation>Finger %1</translation>
    </message>
    <message>
        <source>finger</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>Lean of the force</source>
        <translation>Neigung der Kraft</translation>
    </message>
    <message>
        <source>farthest that the platform leans</source>
        <translation>weiteste Neigung der Plattform</translation>
    </message>
    <message>
        <source>Lean (°), line: as far as the platform leans</source>
        <translation>Neigung (°), Linie: so weit neigt sich die Plattform</translation>
    </message>
    <message>
        <source>Depth of the fingers</source>
        <translation>Tiefe der Finger</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>Pull on the fold of tissue</source>
        <translation>Zug an der Gewebefalte</translation>
    </message>
    <message>
        <source>pull</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>Pull on the fold (N), dashed: its band</source>
        <translation>Zug an der Falte (N), gestrichelt: Zielbereich</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Tissue force (N)</source>
        <translation>Kraft am Gewebe (N)</translation>
    </message>
    <message>
        <source>Force felt (N)</source>
        <translation>Kraft gefühlt (N)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlaybackScreen</name>
    <message>
        <source>Sessions to compare with could not be listed.</source>
        <translation>Sitzungen zum Vergleichen konnten nicht aufgelistet werden.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>My first attempt, %1</source>
        <translation>Mein erster Versuch, %1</translation>
    </message>
    <message>
        <source>First attempt of %1, %2</source>
        <translation>Erster Versuch von %1, %2</translation>
    </message>
    <message>
        <source>My best attempt, %1</source>
        <translation>Mein bester Versuch, %1</translation>
    </message>
    <message>
        <source>Best attempt of %1, %2</source>
        <translation>Bester Versuch von %1, %2</translation>
    </message>
    <message>
        <source>No other completed session of this level</source>
        <translation>Keine andere abgeschlossene Sitzung dieser Stufe</translation>
    </message>
    <message>
        <source>The second session could not be read. This one is shown alone.</source>
        <translation>Die zweite Sitzung konnte nicht gelesen werden. Diese wird allein gezeigt.</translation>
    </message>
    <message>
        <source>Declared void: %1</source>
        <translation>Für ungültig erklärt: %1</translation>
    </message>
    <message>
        <source>%1, level %2: %3</source>
        <translation>%1, Stufe %2: %3</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 · %4</source>
        <translation>%1 · %2 · %3 · %4</translation>
    </message>
    <message>
        <source>Debrief</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Declare void …</source>
        <translation>Für ungültig erklären …</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>Second session beside it</source>
        <translation>Zweite Sitzung daneben</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>One picture on</source>
        <translation>Ein Bild vor</translation>
    </message>
    <message>
        <source>One picture back</source>
        <translation>Ein Bild zurück</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Nächstes Ereignis</translation>
    </message>
    <message>
        <source>Last event</source>
        <translation>Voriges Ereignis</translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>This recording is damaged and cannot be played back. Its scores are kept.</source>
        <translation>Diese Aufzeichnung ist beschädigt und kann nicht wiedergegeben werden. Ihre Wertungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>This session could not be opened</source>
        <translation>Diese Sitzung konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Reading the recording …</source>
        <translation>Aufzeichnung wird gelesen …</translation>
    </message>
    <message>
        <source>The recording was erased</source>
        <translation>Die Aufzeichnung wurde gelöscht</translation>
    </message>
    <message>
        <source>It was withdrawn at the person&apos;s wish. The scores are kept.</source>
        <translation>Sie wurde auf Wunsch der Person gelöscht. Die Wertungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>Open the debrief</source>
        <translation>Auswertung öffnen</translation>
    </message>
    <message>
        <source>Nothing was recorded</source>
        <translation>Nichts wurde aufgezeichnet</translation>
    </message>
    <message>
        <source>This session ended before its first sample. It is kept and listed.</source>
        <translation>Diese Sitzung endete vor ihrem ersten Messpunkt. Sie bleibt erhalten und in der Liste.</translation>
    </message>
    <message>
        <source>The scene at this moment</source>
        <translation>Die Szene in diesem Moment</translation>
    </message>
    <message>
        <source>Trial %1 · force %2 · speed %3</source>
        <translation>Durchgang %1 · Kraft %2 · Tempo %3</translation>
    </message>
    <message>
        <source>The comments could not be read.</source>
        <translation>Die Kommentare konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The comment was not stored. Its text is still there.</source>
        <translation>Der Kommentar wurde nicht gespeichert. Sein Text ist noch da.</translation>
    </message>
    <message>
        <source>The session was not declared void; nothing was changed.</source>
        <translation>Die Sitzung wurde nicht für ungültig erklärt; es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>The session is void. Recording and scores are kept.</source>
        <translation>Die Sitzung ist ungültig. Aufzeichnung und Wertungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>second session</source>
        <translation>zweite Sitzung</translation>
    </message>
    <message>
        <source>Depth of field</source>
        <translation>Schärfentiefe</translation>
    </message>
    <message>
        <source>The picture is sharp at one distance only, as through a real endoscope</source>
        <translation>Das Bild ist nur in einer Entfernung scharf, wie durch ein echtes Endoskop</translation>
    </message>
    <message>
        <source>A session as it was recorded.

Space plays and pauses. The arrow keys go one picture on or back, with Shift one second, with Ctrl to the next or last event; Home and End go to the ends. A click in a plot goes there too.

Pauses are hatched. Triangles on the time bar are penalties, flags are answers, squares below it are comments.

Choose a second session to see it beside this one: each of its trials starts when the trial here starts, and it is drawn in the same place.</source>
        <translation>Eine Sitzung, wie sie aufgezeichnet wurde.

Die Leertaste startet und hält an. Die Pfeiltasten gehen ein Bild vor oder zurück, mit Umschalt eine Sekunde, mit Strg zum nächsten oder vorigen Ereignis; Pos1 und Ende gehen an die Enden. Ein Klick in ein Diagramm führt ebenfalls dorthin.

Pausen sind schraffiert. Dreiecke auf der Zeitleiste sind Abzüge, Fahnen sind Antworten, Quadrate darunter sind Kommentare.

Wählen Sie eine zweite Sitzung, um sie neben dieser zu sehen: Jeder ihrer Durchgänge beginnt, wenn der Durchgang hier beginnt, und sie wird an derselben Stelle gezeichnet.</translation>
    </message>
    <message>
        <source>%1 · depth %2 · force %3 · speed %4</source>
        <translation>%1 · Tiefe %2 · Kraft %3 · Tempo %4</translation>
    </message>
    <message>
        <source>squeeze %1</source>
        <translation>Quetschkraft %1</translation>
    </message>
    <message>
        <source>tension %1</source>
        <translation>Spannung %1</translation>
    </message>
    <message>
        <source>Trial %1 · %2 · force %3 · speed %4</source>
        <translation>Durchgang %1 · %2 · Kraft %3 · Tempo %4</translation>
    </message>
    <message>
        <source>Show the lumps</source>
        <translation>Knoten zeigen</translation>
    </message>
    <message>
        <source>Where the lumps were, and what became of the findings</source>
        <translation>Wo die Knoten waren und was aus den Funden wurde</translation>
    </message>
    <message>
        <source>Map of the whole trial</source>
        <translation>Karte des ganzen Durchgangs</translation>
    </message>
    <message>
        <source>Off: the map as it was at this moment</source>
        <translation>Aus: die Karte in diesem Augenblick</translation>
    </message>
    <message>
        <source>Map: how hard</source>
        <translation>Karte: wie fest</translation>
    </message>
    <message>
        <source>On: how hard was pressed. Off: where was searched.</source>
        <translation>An: wie fest gedrückt wurde. Aus: wo gesucht wurde.</translation>
    </message>
    <message>
        <source>Trial %1 · force %2 · lean %3° · depth %4 · searched %5 % · findings %6</source>
        <translation>Durchgang %1 · Kraft %2 · Neigung %3° · Tiefe %4 · abgetastet %5 % · Funde %6</translation>
    </message>
    <message>
        <source>Findings and maps could not be read from the recording: %1</source>
        <translation>Funde und Karten ließen sich aus der Aufzeichnung nicht lesen: %1</translation>
    </message>
    <message>
        <source>Trial %1 · %7 · force %2 · lean %3° · depth %4 · searched %5 % · findings %6</source>
        <translation>Durchgang %1 · %7 · Kraft %2 · Neigung %3° · Tiefe %4 · abgetastet %5 % · Funde %6</translation>
    </message>
    <message>
        <source>force stopped</source>
        <translation>Kraft angehalten</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1 · %2 · depth %3 · force %4 · speed %5</source>
        <translation>%1 · %2 · Tiefe %3 · Kraft %4 · Tempo %5</translation>
    </message>
    <message>
        <source>Trial %1 · %2 · %3 · force %4 · speed %5</source>
        <translation>Durchgang %1 · %2 · %3 · Kraft %4 · Tempo %5</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PreviewPage</name>
    <message>
        <source>Simulated observers do the study, without rendering. What they are like is known, so that bias and precision can be told before the first participant.</source>
        <translation>Simulierte Beobachter machen die Studie, ohne Wiedergabe. Wie sie sind, ist bekannt; so lassen sich Verzerrung und Genauigkeit vor der ersten Person angeben.</translation>
    </message>
    <message>
        <source>Their Weber fraction</source>
        <translation>Ihr Weber-Bruch</translation>
    </message>
    <message>
        <source>Answers that are guessed</source>
        <translation>Geratene Antworten</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Progress of the preview</source>
        <translation>Fortschritt der Vorschau</translation>
    </message>
    <message>
        <source>The preview could not be made. %1</source>
        <translation>Die Vorschau gelang nicht. %1</translation>
    </message>
    <message>
        <source>expected bias of the Weber fraction</source>
        <translation>erwartete Verzerrung des Weber-Bruchs</translation>
    </message>
    <message>
        <source>precision: SD of one run, as a factor</source>
        <translation>Genauigkeit: SD eines Laufs, als Faktor</translation>
    </message>
    <message>
        <source>trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>minutes, breaks included</source>
        <translation>Minuten, mit Pausen</translation>
    </message>
    <message>
        <source>95 % intervals that hold the truth</source>
        <translation>95-%-Intervalle, die die Wahrheit enthalten</translation>
    </message>
    <message>
        <source>How the estimate settles with more trials</source>
        <translation>Wie sich die Schätzung mit mehr Durchgängen setzt</translation>
    </message>
    <message>
        <source>Trials of a run</source>
        <translation>Durchgänge eines Laufs</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Weber-Bruch (%)</translation>
    </message>
    <message numerus="yes">
        <source>middle of %n run(s)</source>
        <translation>
            <numerusform>%n Lauf</numerusform>
            <numerusform>Mitte von %n Läufen</numerusform>
        </translation>
    </message>
    <message>
        <source>middle 80 %</source>
        <translation>mittlere 80 %</translation>
    </message>
    <message>
        <source>true value</source>
        <translation>wahrer Wert</translation>
    </message>
    <message>
        <source>They call equal, below (in σ)</source>
        <translation>Gleich genannt wird unter (in σ)</translation>
    </message>
    <message>
        <source>The conditions are sealed while the study is blind, and with them what a preview would say. Its author can make one.</source>
        <translation>Solange die Studie blind ist, sind die Bedingungen versiegelt und damit auch, was eine Vorschau sagen würde. Wer die Studie verfasst hat, kann eine machen.</translation>
    </message>
    <message>
        <source>Runs per condition</source>
        <translation>Läufe je Bedingung</translation>
    </message>
    <message>
        <source>±: one standard error of so few simulated runs; more runs make it smaller.</source>
        <translation>±: ein Standardfehler bei so wenigen simulierten Durchläufen; mehr Durchläufe machen ihn kleiner.</translation>
    </message>
    <message>
        <source>For comparing two conditions, the spread between people is assumed, not simulated. Changes show at once.</source>
        <translation>Für den Vergleich zweier Bedingungen wird angenommen, nicht simuliert, wie sich Personen unterscheiden. Änderungen zeigen sich sofort.</translation>
    </message>
    <message>
        <source>Each participant does both conditions</source>
        <translation>Jede Person macht beide Bedingungen</translation>
    </message>
    <message>
        <source>Participants (of two groups: in each)</source>
        <translation>Personen (bei zwei Gruppen: je Gruppe)</translation>
    </message>
    <message>
        <source>Paired: SD of the difference from person to person (log10)</source>
        <translation>Gepaart: SD des Unterschieds von Person zu Person (log10)</translation>
    </message>
    <message>
        <source>Two groups: SD between people (log10)</source>
        <translation>Zwei Gruppen: SD zwischen Personen (log10)</translation>
    </message>
    <message>
        <source>Significance level, two-sided</source>
        <translation>Signifikanzniveau, zweiseitig</translation>
    </message>
    <message>
        <source>Power wanted</source>
        <translation>Gewünschte Teststärke</translation>
    </message>
    <message>
        <source>none up to × 10</source>
        <translation>keines bis × 10</translation>
    </message>
    <message>
        <source>smallest ratio found with %1 power by %2 participants who do both conditions</source>
        <translation>kleinstes Verhältnis, das %2 Personen, die beide Bedingungen machen, mit %1 Teststärke finden</translation>
    </message>
    <message>
        <source>smallest ratio found with %1 power by two groups of %2 participants</source>
        <translation>kleinstes Verhältnis, das zwei Gruppen von je %2 Personen mit %1 Teststärke finden</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ProcedureForm</name>
    <message>
        <source>Procedure</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Another procedure</source>
        <translation>Anderes Verfahren</translation>
    </message>
    <message>
        <source>First x</source>
        <translation>Erstes x</translation>
    </message>
    <message>
        <source>Right answers for a step down</source>
        <translation>Richtige Antworten bis zum Schritt nach unten</translation>
    </message>
    <message>
        <source>Wrong answers for a step up</source>
        <translation>Falsche Antworten bis zum Schritt nach oben</translation>
    </message>
    <message>
        <source>Step down : step up (0: as listed)</source>
        <translation>Schritt ab : Schritt auf (0: wie aufgeführt)</translation>
    </message>
    <message>
        <source>Steps are</source>
        <translation>Schritte werden</translation>
    </message>
    <message>
        <source>added</source>
        <translation>addiert</translation>
    </message>
    <message>
        <source>in log10 units</source>
        <translation>in log10-Einheiten</translation>
    </message>
    <message>
        <source>in dB</source>
        <translation>in dB</translation>
    </message>
    <message>
        <source>Reversals averaged</source>
        <translation>Gemittelte Umkehrungen</translation>
    </message>
    <message>
        <source>Steps up, by number of reversals</source>
        <translation>Schritte auf, nach Zahl der Umkehrungen</translation>
    </message>
    <message>
        <source>Steps down (empty: as up)</source>
        <translation>Schritte ab (leer: wie auf)</translation>
    </message>
    <message>
        <source>1-up/1-down until the first reversal</source>
        <translation>1-auf/1-ab bis zur ersten Umkehrung</translation>
    </message>
    <message>
        <source>Counters start anew at each step</source>
        <translation>Zähler beginnen nach jedem Schritt neu</translation>
    </message>
    <message>
        <source>New step size at the reversal itself</source>
        <translation>Neue Schrittweite schon bei der Umkehrung</translation>
    </message>
    <message>
        <source>Stay within the range</source>
        <translation>Im Bereich bleiben</translation>
    </message>
    <message>
        <source>Proportion aimed at</source>
        <translation>Angestrebter Anteil</translation>
    </message>
    <message>
        <source>Wald deviation</source>
        <translation>Wald-Abweichung</translation>
    </message>
    <message>
        <source>First step</source>
        <translation>Erster Schritt</translation>
    </message>
    <message>
        <source>Smallest step</source>
        <translation>Kleinster Schritt</translation>
    </message>
    <message>
        <source>Largest step</source>
        <translation>Größter Schritt</translation>
    </message>
    <message>
        <source>Trials a level</source>
        <translation>Durchgänge je Stufe</translation>
    </message>
    <message>
        <source>In random order</source>
        <translation>In zufälliger Folge</translation>
    </message>
    <message>
        <source>Levels (x)</source>
        <translation>Stufen (x)</translation>
    </message>
    <message>
        <source>Presentations a level</source>
        <translation>Darbietungen je Stufe</translation>
    </message>
    <message>
        <source>Right ones to go on</source>
        <translation>Richtige, um weiterzugehen</translation>
    </message>
    <message>
        <source>Levels (x), falling</source>
        <translation>Stufen (x), fallend</translation>
    </message>
    <message>
        <source>Prior: mean threshold</source>
        <translation>Prior: mittlere Schwelle</translation>
    </message>
    <message>
        <source>Prior: SD</source>
        <translation>Prior: SD</translation>
    </message>
    <message>
        <source>Slope β</source>
        <translation>Steigung β</translation>
    </message>
    <message>
        <source>Lapses δ</source>
        <translation>Aussetzer δ</translation>
    </message>
    <message>
        <source>Guesses γ</source>
        <translation>Raten γ</translation>
    </message>
    <message>
        <source>Trials are placed at</source>
        <translation>Durchgänge liegen bei</translation>
    </message>
    <message>
        <source>Quantile</source>
        <translation>Quantil</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Psychometric function</source>
        <translation>Psychometrische Funktion</translation>
    </message>
    <message>
        <source>Same stimulus in a row (0: any)</source>
        <translation>Gleicher Reiz hintereinander (0: beliebig)</translation>
    </message>
    <message>
        <source>Share of catch trials</source>
        <translation>Anteil der Kontrolldurchgänge</translation>
    </message>
    <message>
        <source>Grid of %1</source>
        <translation>Raster von %1</translation>
    </message>
    <message>
        <source>Grid of lapses</source>
        <translation>Raster der Aussetzer</translation>
    </message>
    <message>
        <source>Grid of noise (log10 σ)</source>
        <translation>Raster des Rauschens (log10 σ)</translation>
    </message>
    <message>
        <source>Change of the procedure</source>
        <translation>Änderung des Verfahrens</translation>
    </message>
    <message>
        <source>Trials at most</source>
        <translation>Höchstens Durchgänge</translation>
    </message>
    <message>
        <source>Trials at least</source>
        <translation>Mindestens Durchgänge</translation>
    </message>
    <message>
        <source>Stop after reversals (0: no)</source>
        <translation>Ende nach Umkehrungen (0: nein)</translation>
    </message>
    <message>
        <source>Stop at precision, SD (0: no)</source>
        <translation>Ende bei Genauigkeit, SD (0: nein)</translation>
    </message>
    <message>
        <source>Grid of ties (in σ)</source>
        <translation>Raster der Gleichstände (in σ)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QualityBox</name>
    <message>
        <source>Results stay sealed until the study is unblinded: answers, times and even the number of trials could tell which condition is which. How well trials went can be seen here, by participant, over all conditions together.</source>
        <translation>Ergebnisse bleiben versiegelt, bis die Studie entblindet ist: Antworten, Zeiten und sogar die Zahl der Durchgänge könnten verraten, welche Bedingung welche ist. Wie gut die Durchgänge liefen, steht hier für jede Person, über alle Bedingungen zusammen.</translation>
    </message>
    <message>
        <source>How many trials there were is shown of those who have done every condition.</source>
        <translation>Wie viele Durchgänge es waren, steht bei denen, die jede Bedingung erledigt haben.</translation>
    </message>
    <message>
        <source>Quality of the trials</source>
        <translation>Qualität der Durchgänge</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Conditions done</source>
        <translation>Bedingungen erledigt</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Verspätete Takte</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Gewertet</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Wiederholt</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>versiegelt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>gefühlt</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>gezeigt, nicht gefühlt</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnaireForm</name>
    <message>
        <source>%1 (may be left out)</source>
        <translation>%1 (darf fehlen)</translation>
    </message>
    <message>
        <source>Please answer this one.</source>
        <translation>Bitte beantworten Sie diese Frage.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>Von %1 bis %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnaireScreen</name>
    <message>
        <source>Questionnaire</source>
        <translation>Fragebogen</translation>
    </message>
    <message>
        <source>A participant answers these questions once.

Tab goes from question to question, the arrow keys move within a scale, Space chooses. What must be answered is marked when it is missing. The answers are stored under the participant&apos;s code as soon as they are handed in.</source>
        <translation>Eine teilnehmende Person beantwortet diese Fragen einmal.

Tab geht von Frage zu Frage, die Pfeiltasten bewegen sich in einer Skala, die Leertaste wählt. Was beantwortet werden muss, wird gekennzeichnet, wenn es fehlt. Die Antworten werden unter dem Code der Person gespeichert, sobald sie abgegeben werden.</translation>
    </message>
    <message>
        <source>Reading the questions …</source>
        <translation>Fragen werden gelesen …</translation>
    </message>
    <message>
        <source>The questionnaire could not be read</source>
        <translation>Der Fragebogen konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>Already answered</source>
        <translation>Schon beantwortet</translation>
    </message>
    <message>
        <source>Each participant answers a questionnaire once.</source>
        <translation>Jede Person beantwortet einen Fragebogen einmal.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>There is no such questionnaire</source>
        <translation>Diesen Fragebogen gibt es nicht</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>Person %1</translation>
    </message>
    <message>
        <source>Hand in</source>
        <translation>Abgeben</translation>
    </message>
    <message>
        <source>The answers were not stored. They are still here.
%1</source>
        <translation>Die Antworten wurden nicht gespeichert. Sie stehen noch hier.
%1</translation>
    </message>
    <message>
        <source>Thank you. The answers are stored.</source>
        <translation>Danke. Die Antworten sind gespeichert.</translation>
    </message>
    <message>
        <source>Leave without handing in?</source>
        <translation>Verlassen ohne abzugeben?</translation>
    </message>
    <message>
        <source>The answers on this page are not stored yet.</source>
        <translation>Die Antworten auf dieser Seite sind noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnaireSummary</name>
    <message>
        <source>This study has no questionnaires.</source>
        <translation>Diese Studie hat keine Fragebögen.</translation>
    </message>
    <message>
        <source>Nobody has answered it yet.</source>
        <translation>Noch niemand hat ihn beantwortet.</translation>
    </message>
    <message numerus="yes">
        <source>Answered by %n participant(s)</source>
        <translation>
            <numerusform>Beantwortet von %n Person</numerusform>
            <numerusform>Beantwortet von %n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>No answers</source>
        <translation>Keine Antworten</translation>
    </message>
    <message>
        <source>Median %1, middle half %2 to %3</source>
        <translation>Median %1, mittlere Hälfte %2 bis %3</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>Antworten</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnairesPage</name>
    <message>
        <source>Scale with words at its ends</source>
        <translation>Skala mit Worten an den Enden</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Free text</source>
        <translation>Freier Text</translation>
    </message>
    <message>
        <source>No questionnaires. They are answered once by each participant, before or after the runs, and kept beside the data.</source>
        <translation>Keine Fragebögen. Jede Person beantwortet sie einmal, vor oder nach den Läufen; sie liegen neben den Daten.</translation>
    </message>
    <message>
        <source>Add a questionnaire</source>
        <translation>Fragebogen hinzufügen</translation>
    </message>
    <message>
        <source>A questionnaire more</source>
        <translation>Ein Fragebogen mehr</translation>
    </message>
    <message>
        <source>Title of the questionnaire</source>
        <translation>Titel des Fragebogens</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Id of a questionnaire</source>
        <translation>Kennung eines Fragebogens</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>Beantwortet</translation>
    </message>
    <message>
        <source>before the runs</source>
        <translation>vor den Läufen</translation>
    </message>
    <message>
        <source>after the runs</source>
        <translation>nach den Läufen</translation>
    </message>
    <message>
        <source>When it is answered</source>
        <translation>Wann er beantwortet wird</translation>
    </message>
    <message>
        <source>Add a question</source>
        <translation>Frage hinzufügen</translation>
    </message>
    <message>
        <source>Remove the questionnaire</source>
        <translation>Fragebogen entfernen</translation>
    </message>
    <message>
        <source>Change of a question</source>
        <translation>Änderung einer Frage</translation>
    </message>
    <message>
        <source>Question %1</source>
        <translation>Frage %1</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Summarised under</source>
        <translation>Zusammengefasst unter</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Lowest means</source>
        <translation>Niedrigste bedeutet</translation>
    </message>
    <message>
        <source>Highest means</source>
        <translation>Höchste bedeutet</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Niedrigste</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Höchste</translation>
    </message>
    <message>
        <source>Choices, one a line</source>
        <translation>Auswahl, je Zeile eine</translation>
    </message>
    <message>
        <source>Must be answered</source>
        <translation>Muss beantwortet werden</translation>
    </message>
    <message>
        <source>Remove question %1</source>
        <translation>Frage %1 entfernen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RankingBox</name>
    <message>
        <source>reference</source>
        <translation>Bezug</translation>
    </message>
    <message>
        <source>D more</source>
        <translation>D mehr</translation>
    </message>
    <message>
        <source>2D more</source>
        <translation>2D mehr</translation>
    </message>
    <message>
        <source>p not known</source>
        <translation>p nicht bekannt</translation>
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
        <translation>Rangfolgen</translation>
    </message>
    <message>
        <source>No ranking counts yet. Agreement and worths will be here as soon as one does.</source>
        <translation>Noch zählt keine Rangfolge. Übereinstimmung und Werte stehen hier, sobald eine zählt.</translation>
    </message>
    <message numerus="yes">
        <source>%n ranking(s) of three objects; each is one judgement.</source>
        <translation>
            <numerusform>%n Rangfolge von drei Objekten; jede ist ein Urteil.</numerusform>
            <numerusform>%n Rangfolgen von drei Objekten; jede ist ein Urteil.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s); each one&apos;s mean ranks are one judgement.</source>
        <translation>
            <numerusform>%n Person; ihre mittleren Ränge sind ein Urteil.</numerusform>
            <numerusform>%n Personen; die mittleren Ränge jeder Person sind ein Urteil.</numerusform>
        </translation>
    </message>
    <message>
        <source>no interval</source>
        <translation>kein Intervall</translation>
    </message>
    <message>
        <source>95 %: %1</source>
        <translation>95 %: %1</translation>
    </message>
    <message>
        <source>Whole orders right</source>
        <translation>Ganze Rangfolgen richtig</translation>
    </message>
    <message>
        <source>%1 of %2; guessing gives 16.7 %.</source>
        <translation>%1 von %2; Raten ergibt 16,7 %.</translation>
    </message>
    <message>
        <source>Kendall&apos;s τ</source>
        <translation>Kendalls τ</translation>
    </message>
    <message>
        <source>Likeness to the true order: 1 the same, 0 no relation, −1 reversed.</source>
        <translation>Ähnlichkeit mit der wahren Rangfolge: 1 gleich, 0 kein Zusammenhang, −1 umgekehrt.</translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation>Kendalls W</translation>
    </message>
    <message>
        <source>How far the rankings agree with each other: 0 not at all, 1 wholly.</source>
        <translation>Wie weit die Rangfolgen übereinstimmen: 0 gar nicht, 1 völlig.</translation>
    </message>
    <message>
        <source>How far the participants agree with each other: 0 not at all, 1 wholly.</source>
        <translation>Wie weit die Personen übereinstimmen: 0 gar nicht, 1 völlig.</translation>
    </message>
    <message>
        <source>Page&apos;s L</source>
        <translation>Pages L</translation>
    </message>
    <message>
        <source>Trend towards the true order; guessing gives %1 on average.</source>
        <translation>Trend zur wahren Rangfolge; Raten ergibt im Mittel %1.</translation>
    </message>
    <message>
        <source>Worth of each object</source>
        <translation>Wert jedes Objekts</translation>
    </message>
    <message>
        <source>How much more often an object was ranked above the others, by three models. Farther apart means easier to tell apart. All differences D of the run are taken together, and each ranking as independent of the others.</source>
        <translation>Wie viel öfter ein Objekt über den anderen stand, nach drei Modellen. Je weiter auseinander, desto leichter zu unterscheiden. Alle Unterschiede D sind zusammengenommen, und jede Rangfolge gilt als unabhängig von den anderen.</translation>
    </message>
    <message>
        <source>No worth is finite: some object was always, or never, ranked above the others. That is what a very clear difference looks like.</source>
        <translation>Kein Wert ist endlich: Ein Objekt stand immer oder nie über den anderen. So sieht ein sehr deutlicher Unterschied aus.</translation>
    </message>
    <message>
        <source>Bradley-Terry</source>
        <translation>Bradley-Terry</translation>
    </message>
    <message>
        <source>ln worth</source>
        <translation>ln Wert</translation>
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
        <source>Scale (sd of a difference)</source>
        <translation>Skala (SD einer Differenz)</translation>
    </message>
    <message>
        <source>Not estimable</source>
        <translation>Nicht schätzbar</translation>
    </message>
    <message>
        <source>estimate with its 95 % interval</source>
        <translation>Schätzung mit 95-%-Intervall</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Worth</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95-%-Intervall</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>not estimable</source>
        <translation>nicht schätzbar</translation>
    </message>
    <message numerus="yes">
        <source>In %n ranking(s) something was called equal.</source>
        <translation>
            <numerusform>In %n Rangfolge wurde etwas gleich genannt.</numerusform>
            <numerusform>In %n Rangfolgen wurde etwas gleich genannt.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2; guessing gives 16.7 % or less.</source>
        <translation>%1 von %2; Raten ergibt 16,7 % oder weniger.</translation>
    </message>
    <message>
        <source>Bradley-Terry, ties by Davidson</source>
        <translation>Bradley-Terry, Gleichstände nach Davidson</translation>
    </message>
    <message>
        <source>Each answer decided what came next, so one person&apos;s trials are not independent: they have no interval and no p.</source>
        <translation>Jede Antwort hat bestimmt, was als Nächstes kam; die Durchgänge einer Person sind deshalb nicht unabhängig: Sie haben kein Intervall und kein p.</translation>
    </message>
    <message>
        <source>no p</source>
        <translation>kein p</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RatingRow</name>
    <message>
        <source>keys 1 to 5</source>
        <translation>Tasten 1 bis 5</translation>
    </message>
    <message>
        <source>%1: %2, %3 of 5</source>
        <translation>%1: %2, %3 von 5</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
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
    <name>chiron::desktop::ResetPasswordDialog</name>
    <message>
        <source>New password for %1</source>
        <translation>Neues Passwort für %1</translation>
    </message>
    <message>
        <source>The present password stops working at once. Sessions and scores are kept.</source>
        <translation>Das jetzige Passwort gilt ab sofort nicht mehr. Sitzungen und Wertungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>Set the password</source>
        <translation>Passwort festlegen</translation>
    </message>
    <message>
        <source>The password of %1 is as it was.
%2</source>
        <translation>Das Passwort von %1 ist unverändert.
%2</translation>
    </message>
    <message>
        <source>%1 has a new password.</source>
        <translation>%1 hat ein neues Passwort.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RestoreDialog</name>
    <message>
        <source>Restore a backup</source>
        <translation>Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>Go back to the backup made %1?</source>
        <translation>Zurück zur Sicherung von %1?</translation>
    </message>
    <message>
        <source>Everything recorded since then leaves the program. The present database is kept aside beside the new one, nothing is deleted. People who were erased stay erased. Everybody is logged out.</source>
        <translation>Alles seither Aufgezeichnete verschwindet aus dem Programm. Die jetzige Datenbank bleibt neben der neuen liegen, nichts wird gelöscht. Gelöschte Personen bleiben gelöscht. Alle werden abgemeldet.</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>Administration</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>The backup has another administrator or password</source>
        <translation>Die Sicherung hat eine andere Administration oder ein anderes Passwort</translation>
    </message>
    <message>
        <source>Administrator in the backup</source>
        <translation>Administration in der Sicherung</translation>
    </message>
    <message>
        <source>Password in the backup</source>
        <translation>Passwort in der Sicherung</translation>
    </message>
    <message>
        <source>Keep the present database</source>
        <translation>Jetzige Datenbank behalten</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ResultsScreen</name>
    <message>
        <source>My results</source>
        <translation>Meine Ergebnisse</translation>
    </message>
    <message>
        <source>Every session you did, and how you are getting on.

Choose an exercise, a level and what is to be drawn. The curve has a point for each completed attempt; force that was felt and force that was only shown are lines of their own and are never compared. The line across is the pass mark, the band what others reached.

Return or a double click opens an attempt. &quot;Export my data&quot; writes everything that is held about you into a folder of your choice.</source>
        <translation>Alle Ihre Sitzungen und wie Sie vorankommen.

Wählen Sie eine Übung, eine Stufe und was gezeichnet werden soll. Die Kurve hat einen Punkt für jeden abgeschlossenen Versuch; gefühlte und nur gezeigte Kraft haben eigene Linien und werden nie verglichen. Die Querlinie ist die Bestehensgrenze, der Bereich das, was andere erreicht haben.

Eingabetaste oder Doppelklick öffnet einen Versuch. „Meine Daten exportieren“ schreibt alles, was über Sie gespeichert ist, in einen Ordner Ihrer Wahl.</translation>
    </message>
    <message>
        <source>Export my data</source>
        <translation>Meine Daten exportieren</translation>
    </message>
    <message>
        <source>Your results could not be read</source>
        <translation>Ihre Ergebnisse konnten nicht gelesen werden</translation>
    </message>
    <message>
        <source>Reading your results …</source>
        <translation>Ihre Ergebnisse werden gelesen …</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>Noch keine Ergebnisse</translation>
    </message>
    <message>
        <source>Your first session will be here, with its scores and its playback.</source>
        <translation>Hier erscheint Ihre erste Sitzung, mit Wertungen und Wiedergabe.</translation>
    </message>
    <message>
        <source>Choose an exercise</source>
        <translation>Übung wählen</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Open the attempt</source>
        <translation>Versuch öffnen</translation>
    </message>
    <message>
        <source>Your data</source>
        <translation>Ihre Daten</translation>
    </message>
    <message>
        <source>A copy of everything that is held about you: your account, sessions, scores, comments and samples. It is yours to keep; nothing is removed here.</source>
        <translation>Eine Kopie von allem, was über Sie gespeichert ist: Konto, Sitzungen, Wertungen, Kommentare und Messpunkte. Sie gehört Ihnen; hier wird nichts entfernt.</translation>
    </message>
    <message>
        <source>Export my data …</source>
        <translation>Meine Daten exportieren …</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>Where should your data go?</source>
        <translation>Wohin sollen Ihre Daten?</translation>
    </message>
    <message>
        <source>Writing your data …</source>
        <translation>Ihre Daten werden geschrieben …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Your data was written to %1.</source>
        <translation>Ihre Daten wurden in %1 geschrieben.</translation>
    </message>
    <message>
        <source>Your data could not be written completely.</source>
        <translation>Ihre Daten konnten nicht vollständig geschrieben werden.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RocBox</name>
    <message>
        <source>How sure, and how right</source>
        <translation>Wie sicher und wie richtig</translation>
    </message>
    <message>
        <source>Reading the recordings …</source>
        <translation>Aufzeichnungen werden gelesen …</translation>
    </message>
    <message>
        <source>The recordings could not be read</source>
        <translation>Die Aufzeichnungen konnten nicht gelesen werden</translation>
    </message>
    <message>
        <source>Not enough answers yet</source>
        <translation>Noch nicht genug Antworten</translation>
    </message>
    <message>
        <source>A curve needs at least %1 places with a lump and as many without. So far: %2 with, %3 without.</source>
        <translation>Eine Kurve braucht mindestens %1 Stellen mit Knoten und ebenso viele ohne. Bisher: %2 mit, %3 ohne.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RoleChoice</name>
    <message>
        <source>Trains, and sees own results</source>
        <translation>Trainiert und sieht die eigenen Ergebnisse</translation>
    </message>
    <message>
        <source>Sees everybody&apos;s sessions, comments and voids them</source>
        <translation>Sieht die Sitzungen aller, kommentiert sie und erklärt sie für ungültig</translation>
    </message>
    <message>
        <source>Sees sessions by code, without names</source>
        <translation>Sieht Sitzungen mit Code, ohne Namen</translation>
    </message>
    <message>
        <source>Looks after people, storage and the station</source>
        <translation>Betreut Personen, Speicher und Arbeitsplatz</translation>
    </message>
    <message>
        <source>Roles (one at least)</source>
        <translation>Rollen (mindestens eine)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RolesDialog</name>
    <message>
        <source>Roles of %1</source>
        <translation>Rollen von %1</translation>
    </message>
    <message>
        <source>It takes effect at once, also for somebody who is logged in.</source>
        <translation>Die Änderung gilt sofort, auch für Personen, die gerade angemeldet sind.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>The roles of %1 are changed.</source>
        <translation>Die Rollen von %1 sind geändert.</translation>
    </message>
    <message>
        <source>%1 stays an administrator: a site needs one who can log in. Make another person an administrator first.</source>
        <translation>%1 behält die Administration: Ein Standort braucht jemanden dafür, der sich anmelden kann. Geben Sie zuerst einer anderen Person diese Rolle.</translation>
    </message>
    <message>
        <source>The roles of %1 were not changed.
%2</source>
        <translation>Die Rollen von %1 wurden nicht geändert.
%2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RosterDialog</name>
    <message>
        <source>Import people</source>
        <translation>Personen importieren</translation>
    </message>
    <message>
        <source>From %1. Nothing is changed before you press Import.</source>
        <translation>Aus %1. Es ändert sich nichts, bevor Sie „Importieren“ drücken.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Reading the list …</source>
        <translation>Liste wird gelesen …</translation>
    </message>
    <message>
        <source>The list could not be compared with the people on this site.</source>
        <translation>Die Liste konnte nicht mit den Personen dieses Standorts verglichen werden.</translation>
    </message>
    <message numerus="yes">
        <source>%n people would be added. Each must choose a password of their own at the first login.</source>
        <translation>
            <numerusform>%n Person würde hinzugefügt. Sie muss bei der ersten Anmeldung ein eigenes Passwort wählen.</numerusform>
            <numerusform>%n Personen würden hinzugefügt. Jede muss bei der ersten Anmeldung ein eigenes Passwort wählen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %n people</source>
        <translation>
            <numerusform>%n Person importieren</numerusform>
            <numerusform>%n Personen importieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing can be imported yet: put these lines right in the file, then choose it again.</source>
        <translation>Es kann noch nichts importiert werden: Berichtigen Sie diese Zeilen in der Datei und wählen Sie sie erneut.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>People in the list</source>
        <translation>Personen in der Liste</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Full name</source>
        <translation>Vollständiger Name</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Nobody was added.
%1</source>
        <translation>Es wurde niemand hinzugefügt.
%1</translation>
    </message>
    <message numerus="yes">
        <source>%n people were added.</source>
        <translation>
            <numerusform>%n Person wurde hinzugefügt.</numerusform>
            <numerusform>%n Personen wurden hinzugefügt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Adding %n people …</source>
        <translation>
            <numerusform>%n Person wird hinzugefügt …</numerusform>
            <numerusform>%n Personen werden hinzugefügt …</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RunScreen</name>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Takes a participant through a study.

Choose the study and the participant&apos;s code. The conditions come in the participant&apos;s own order; where the experimenter is blind they go by sealed codes. Questionnaires before and after are answered here, too.

A run that was interrupted goes on at the trial where it stopped.</source>
        <translation>Führt eine Person durch eine Studie.

Wählen Sie die Studie und den Code der Person. Die Bedingungen kommen in ihrer eigenen Reihenfolge; wo die Versuchsleitung blind ist, unter versiegelten Codes. Auch die Fragebögen davor und danach werden hier beantwortet.

Ein unterbrochener Lauf geht bei dem Durchgang weiter, bei dem er aufhörte.</translation>
    </message>
    <message>
        <source>Reading the studies …</source>
        <translation>Studien werden gelesen …</translation>
    </message>
    <message>
        <source>The studies could not be read</source>
        <translation>Die Studien konnten nicht gelesen werden</translation>
    </message>
    <message>
        <source>No study can be run yet</source>
        <translation>Noch lässt sich keine Studie durchführen</translation>
    </message>
    <message>
        <source>A study is run once its design is frozen and participants are enrolled.</source>
        <translation>Eine Studie wird durchgeführt, sobald ihr Entwurf eingefroren ist und Personen aufgenommen sind.</translation>
    </message>
    <message>
        <source>Open the studies</source>
        <translation>Studien öffnen</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Participant, by code</source>
        <translation>Person, nach Code</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Nobody is enrolled yet.</source>
        <translation>Noch ist niemand aufgenommen.</translation>
    </message>
    <message>
        <source>Enrol somebody</source>
        <translation>Jemanden aufnehmen</translation>
    </message>
    <message>
        <source>Consent is missing. Record it under the study&apos;s participants first.</source>
        <translation>Die Einwilligung fehlt. Halten Sie sie zuerst bei den Teilnehmenden der Studie fest.</translation>
    </message>
    <message>
        <source>Open the participants</source>
        <translation>Teilnehmende öffnen</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>to come</source>
        <translation>kommt noch</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>answered</source>
        <translation>beantwortet</translation>
    </message>
    <message>
        <source>not answered yet</source>
        <translation>noch nicht beantwortet</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Beantworten</translation>
    </message>
    <message>
        <source>Answer %1</source>
        <translation>%1 beantworten</translation>
    </message>
    <message>
        <source>Begin %1</source>
        <translation>%1 beginnen</translation>
    </message>
    <message>
        <source>interrupted at trial %1 of at most %2</source>
        <translation>unterbrochen bei Durchgang %1 von höchstens %2</translation>
    </message>
    <message>
        <source>interrupted at trial %1</source>
        <translation>unterbrochen bei Durchgang %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Resume here</source>
        <translation>Hier fortsetzen</translation>
    </message>
    <message>
        <source>Resume %1 where it was interrupted</source>
        <translation>%1 fortsetzen, wo unterbrochen wurde</translation>
    </message>
    <message>
        <source>Others who were interrupted</source>
        <translation>Andere, die unterbrochen wurden</translation>
    </message>
    <message>
        <source>interrupted, %1</source>
        <translation>unterbrochen, %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::Scrubber</name>
    <message>
        <source>Position in the recording</source>
        <translation>Position in der Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionFilterBar</name>
    <message>
        <source>Search in the list</source>
        <translation>In der Liste suchen</translation>
    </message>
    <message>
        <source>Search: person, exercise, number</source>
        <translation>Person, Übung, Nummer</translation>
    </message>
    <message>
        <source>Archived too</source>
        <translation>Auch archivierte</translation>
    </message>
    <message>
        <source>Clear the filters</source>
        <translation>Filter löschen</translation>
    </message>
    <message>
        <source>Everybody</source>
        <translation>Alle Personen</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Every exercise</source>
        <translation>Alle Übungen</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Every level</source>
        <translation>Alle Stufen</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation>Stufe %1</translation>
    </message>
    <message>
        <source>Every state</source>
        <translation>Alle Zustände</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Every result</source>
        <translation>Alle Ergebnisse</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Felt and shown</source>
        <translation>Gefühlt und gezeigt</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>Alle Zeiten</translation>
    </message>
    <message>
        <source>When it was recorded</source>
        <translation>Zeitpunkt der Aufzeichnung</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Letzte 7 Tage</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Letzte 30 Tage</translation>
    </message>
    <message>
        <source>Chosen days</source>
        <translation>Bestimmte Tage</translation>
    </message>
    <message>
        <source>From this day</source>
        <translation>Ab diesem Tag</translation>
    </message>
    <message>
        <source>To this day</source>
        <translation>Bis zu diesem Tag</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionLines</name>
    <message>
        <source>%1: %2, level %3</source>
        <translation>%1: %2, Stufe %3</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1, Stufe %2</translation>
    </message>
    <message>
        <source>%1. %2. %3. Opens the debrief.</source>
        <translation>%1. %2. %3. Öffnet die Auswertung.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionTableModel</name>
    <message>
        <source>%1, archived</source>
        <translation>%1, archiviert</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>versiegelt</translation>
    </message>
    <message>
        <source>How long a sitting of a blinded study took is told once the study is unblinded.</source>
        <translation>Wie lange eine Sitzung einer verblindeten Studie dauerte, wird angegeben, sobald die Studie entblindet ist.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionsScreen</name>
    <message>
        <source>Search in the list</source>
        <translation>In der Liste suchen</translation>
    </message>
    <message>
        <source>Save the list …</source>
        <translation>Liste speichern …</translation>
    </message>
    <message>
        <source>Bring back from the archive</source>
        <translation>Aus dem Archiv holen</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivieren</translation>
    </message>
    <message>
        <source>Session %1 is still running. It can be opened as soon as it has ended.</source>
        <translation>Sitzung %1 läuft noch. Sie lässt sich öffnen, sobald sie beendet ist.</translation>
    </message>
    <message>
        <source>Session %1 was not voided.</source>
        <translation>Sitzung %1 wurde nicht für ungültig erklärt.</translation>
    </message>
    <message>
        <source>Session %1 is voided. Its recording is kept; it no longer counts.</source>
        <translation>Sitzung %1 ist für ungültig erklärt. Ihre Aufzeichnung bleibt erhalten; sie zählt nicht mehr.</translation>
    </message>
    <message>
        <source>Session %1 was not changed.</source>
        <translation>Sitzung %1 wurde nicht geändert.</translation>
    </message>
    <message>
        <source>Session %1 is archived: nothing was deleted.</source>
        <translation>Sitzung %1 ist archiviert: Es wurde nichts gelöscht.</translation>
    </message>
    <message>
        <source>Session %1 is back in the list.</source>
        <translation>Sitzung %1 ist wieder in der Liste.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>The session could not be read again.</source>
        <translation>Die Sitzung konnte nicht erneut gelesen werden.</translation>
    </message>
    <message>
        <source>Save the list</source>
        <translation>Liste speichern</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Kommagetrennte Werte (*.csv)</translation>
    </message>
    <message>
        <source>The list is saved in %1.</source>
        <translation>Die Liste ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source>The list was not saved.</source>
        <translation>Die Liste wurde nicht gespeichert.</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Every session that was recorded on this site, newest first.

Type in the search field or choose from the lists beside it to narrow the list; the filters stay when you come back. Click a column&apos;s head to sort by it.

Enter or a double click opens the debrief of the selected session, Ctrl+P plays it. Void takes a session out of every count, with a reason, and keeps it. Archive takes it out of the usual lists and can be undone.</source>
        <translation>Jede an diesem Standort aufgezeichnete Sitzung, neueste zuerst.

Geben Sie etwas in das Suchfeld ein oder wählen Sie aus den Listen daneben, um die Liste einzugrenzen; die Filter bleiben, wenn Sie zurückkommen. Ein Klick auf einen Spaltenkopf sortiert danach.

Eingabetaste oder Doppelklick öffnet die Auswertung der gewählten Sitzung, Strg+P gibt sie wieder. „Für ungültig erklären“ nimmt eine Sitzung mit Begründung aus jeder Zählung und behält sie. „Archivieren“ nimmt sie aus den üblichen Listen und lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Open the debrief</source>
        <translation>Auswertung öffnen</translation>
    </message>
    <message>
        <source>Play back</source>
        <translation>Wiedergeben</translation>
    </message>
    <message>
        <source>Void …</source>
        <translation>Für ungültig erklären …</translation>
    </message>
    <message>
        <source>Loading the sessions …</source>
        <translation>Sitzungen werden geladen …</translation>
    </message>
    <message>
        <source>The sessions could not be loaded.</source>
        <translation>Die Sitzungen konnten nicht geladen werden.</translation>
    </message>
    <message>
        <source>Loading the older sessions …</source>
        <translation>Ältere Sitzungen werden geladen …</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n Sitzung</numerusform>
            <numerusform>%n Sitzungen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 sessions</source>
        <translation>%1 von %2 Sitzungen</translation>
    </message>
    <message>
        <source>No session has been recorded yet</source>
        <translation>Noch keine Sitzung aufgezeichnet</translation>
    </message>
    <message>
        <source>As soon as somebody trains, the session is listed here.</source>
        <translation>Sobald jemand trainiert, erscheint die Sitzung hier.</translation>
    </message>
    <message>
        <source>No session matches these filters</source>
        <translation>Keine Sitzung passt zu diesen Filtern</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) in all.</source>
        <translation>
            <numerusform>%n Sitzung insgesamt.</numerusform>
            <numerusform>%n Sitzungen insgesamt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Clear the filters</source>
        <translation>Filter löschen</translation>
    </message>
    <message>
        <source>A sitting of a blinded study can be looked at once the study is unblinded.</source>
        <translation>Eine Sitzung einer verblindeten Studie lässt sich ansehen, sobald die Studie entblindet ist.</translation>
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
        <source>Play sounds while training</source>
        <translation>Töne beim Training</translation>
    </message>
    <message>
        <source>A click when contact begins</source>
        <translation>Ein Klick, wenn die Berührung beginnt</translation>
    </message>
    <message>
        <source>A tone that rises with force</source>
        <translation>Ein Ton, der mit der Kraft steigt</translation>
    </message>
    <message>
        <source>A warning over the limit</source>
        <translation>Eine Warnung über der Grenze</translation>
    </message>
    <message>
        <source>Brighter when force leans</source>
        <translation>Heller bei geneigter Kraft</translation>
    </message>
    <message>
        <source>What can be heard is shown too. The force behind it is recorded, heard or not.</source>
        <translation>Was zu hören ist, ist auch zu sehen. Die Kraft dahinter wird aufgezeichnet, gehört oder nicht.</translation>
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
    <name>chiron::desktop::SignedBar</name>
    <message>
        <source>%1 %2, over the limit</source>
        <translation>%1 %2, über der Grenze</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>über der Grenze</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SizeRow</name>
    <message>
        <source>Size: one millimetre smaller</source>
        <translation>Größe: einen Millimeter kleiner</translation>
    </message>
    <message>
        <source>Size: one millimetre larger</source>
        <translation>Größe: einen Millimeter größer</translation>
    </message>
    <message>
        <source>Dashed: the pad of the finger. Keys + and −</source>
        <translation>Gestrichelt: die Fingerkuppe. Tasten + und −</translation>
    </message>
    <message>
        <source>Size: %1</source>
        <translation>Größe: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SoundSign</name>
    <message>
        <source>What sounds</source>
        <translation>Was klingt</translation>
    </message>
    <message>
        <source>What can be heard: contact begins, how high the tone is, the warning</source>
        <translation>Was zu hören ist: beginnende Berührung, Höhe des Tons, die Warnung</translation>
    </message>
    <message>
        <source>Warning: pressed too hard</source>
        <translation>Warnung: zu fest gedrückt</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>No tone</source>
        <translation>Kein Ton</translation>
    </message>
    <message>
        <source>Low tone</source>
        <translation>Tiefer Ton</translation>
    </message>
    <message>
        <source>Medium tone</source>
        <translation>Mittlerer Ton</translation>
    </message>
    <message>
        <source>High tone</source>
        <translation>Hoher Ton</translation>
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
    <name>chiron::desktop::StationScreen</name>
    <message>
        <source>Station</source>
        <translation>Arbeitsplatz</translation>
    </message>
    <message>
        <source>Looking at the station …</source>
        <translation>Arbeitsplatz wird geprüft …</translation>
    </message>
    <message>
        <source>The station could not be looked at.</source>
        <translation>Der Arbeitsplatz konnte nicht geprüft werden.</translation>
    </message>
    <message>
        <source>Punctuality of the force loop</source>
        <translation>Pünktlichkeit der Kraftregelung</translation>
    </message>
    <message>
        <source>Session %1, %2</source>
        <translation>Sitzung %1, %2</translation>
    </message>
    <message>
        <source>None of the latest sessions ran against the clock, so nothing is known yet of how punctual this station is.</source>
        <translation>Keine der letzten Sitzungen lief in Echtzeit; wie pünktlich dieser Arbeitsplatz ist, ist noch nicht bekannt.</translation>
    </message>
    <message>
        <source>Self-test without a device</source>
        <translation>Selbsttest ohne Gerät</translation>
    </message>
    <message>
        <source>Run the self-test</source>
        <translation>Selbsttest starten</translation>
    </message>
    <message>
        <source>An administrator can run it here.</source>
        <translation>Die Administration kann ihn hier starten.</translation>
    </message>
    <message>
        <source>This session was recorded before the spread of lateness was kept.</source>
        <translation>Diese Sitzung wurde aufgezeichnet, bevor die Verteilung der Verspätung gespeichert wurde.</translation>
    </message>
    <message>
        <source>The system said: %1</source>
        <translation>Das System meldete: %1</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>No device that makes force felt by a hand is connected: this version has no driver for one yet.</source>
        <translation>Kein Gerät mit fühlbarer Kraft ist angeschlossen: Diese Version hat noch keinen Treiber dafür.</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>A running session keeps its last seconds in memory, so that a crash loses nothing: %1 of the %2 that are free there.</source>
        <translation>Eine laufende Sitzung hält ihre letzten Sekunden im Arbeitsspeicher, damit bei einem Absturz nichts verloren geht: %1 von %2, die dort frei sind.</translation>
    </message>
    <message>
        <source>Testing the loop. Do not use the computer meanwhile.</source>
        <translation>Die Regelung wird geprüft. Benutzen Sie den Computer währenddessen nicht.</translation>
    </message>
    <message>
        <source>The self-test was stopped before its end.</source>
        <translation>Der Selbsttest wurde vorzeitig abgebrochen.</translation>
    </message>
    <message>
        <source>Verifying the fingertip platform.</source>
        <translation>Die Fingerkuppen-Plattform wird geprüft.</translation>
    </message>
    <message>
        <source>Write the record</source>
        <translation>Protokoll schreiben</translation>
    </message>
    <message>
        <source>Fingertip platform.pdf</source>
        <translation>Fingerkuppen-Plattform.pdf</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-Dokumente (*.pdf)</translation>
    </message>
    <message>
        <source>%1, on %2</source>
        <translation>%1, am %2</translation>
    </message>
    <message>
        <source>The record was written to %1.</source>
        <translation>Das Protokoll wurde in %1 geschrieben.</translation>
    </message>
    <message>
        <source>The record could not be written.</source>
        <translation>Das Protokoll konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Whether this computer is fit to make force felt.

Force is computed a thousand times a second. The charts show how late those thousand steps began: in the last session that ran against the clock, and in a self-test of ten seconds without any device.

The fingertip platform is verified as published: how closely it follows a force and an orientation. The record can be printed.

With real-time priority the loop keeps its time whatever else the computer does. This screen says whether it has it and how to permit it.</source>
        <translation>Ob dieser Rechner geeignet ist, Kraft fühlbar zu machen.

Die Kraft wird tausendmal in der Sekunde berechnet. Die Diagramme zeigen, wie spät diese tausend Schritte begannen: in der letzten Sitzung, die gegen die Uhr lief, und in einem Selbsttest von zehn Sekunden ohne Gerät.

Die Fingerkuppen-Plattform wird wie veröffentlicht geprüft: wie genau sie einer Kraft und einer Neigung folgt. Das Protokoll lässt sich drucken.

Mit Echtzeitpriorität hält die Schleife ihre Zeit, was immer der Rechner sonst tut. Dieser Bildschirm sagt, ob sie sie hat und wie man sie erlaubt.</translation>
    </message>
    <message>
        <source>Verify the fingertip platform</source>
        <translation>Fingerkuppen-Plattform prüfen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StorageScreen</name>
    <message>
        <source>Storage</source>
        <translation>Speicher</translation>
    </message>
    <message>
        <source>Where everything that was recorded is kept, and whether it is safe.

Back up now makes a copy beside the running program and checks it before it counts. Keep backups on another disk: choose the folder here.

Verify reads everything again: each record, each recording, each score, the audit trail. It changes nothing and can be stopped.

Restore goes back to a backup. It asks an administrator for the password, keeps the present database aside, and logs everybody out.</source>
        <translation>Wo alles Aufgezeichnete liegt und ob es sicher ist.

„Jetzt sichern“ erstellt eine Kopie, während das Programm läuft, und prüft sie, bevor sie gilt. Bewahren Sie Sicherungen auf einer anderen Festplatte auf: Wählen Sie hier den Ordner.

„Prüfen“ liest alles noch einmal: jeden Datensatz, jede Aufzeichnung, jede Wertung, das Prüfprotokoll. Es ändert nichts und lässt sich abbrechen.

„Wiederherstellen“ kehrt zu einer Sicherung zurück. Es fragt die Administration nach dem Passwort, legt die jetzige Datenbank beiseite und meldet alle ab.</translation>
    </message>
    <message>
        <source>Room</source>
        <translation>Platz</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>Datenbank</translation>
    </message>
    <message>
        <source>Recordings in it</source>
        <translation>Aufzeichnungen darin</translation>
    </message>
    <message>
        <source>Free on this disk</source>
        <translation>Auf dieser Festplatte frei</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Erstellt</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Back up now</source>
        <translation>Jetzt sichern</translation>
    </message>
    <message>
        <source>Check the selected backup</source>
        <translation>Gewählte Sicherung prüfen</translation>
    </message>
    <message>
        <source>Restore the selected backup …</source>
        <translation>Gewählte Sicherung wiederherstellen …</translation>
    </message>
    <message>
        <source>Choose the folder …</source>
        <translation>Ordner wählen …</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Reads every record, recomputes every score from its recording and follows the audit trail. It changes nothing.</source>
        <translation>Liest jeden Datensatz, berechnet jede Wertung aus ihrer Aufzeichnung neu und verfolgt das Prüfprotokoll. Es ändert nichts.</translation>
    </message>
    <message>
        <source>What does not hold</source>
        <translation>Was nicht stimmt</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Verify everything</source>
        <translation>Alles prüfen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>A backup and every table as text (JSON Lines, without passwords), for analysis elsewhere or to leave this program with everything.</source>
        <translation>Eine Sicherung und jede Tabelle als Text (JSON Lines, ohne Passwörter), zur Auswertung anderswo oder um dieses Programm mit allem zu verlassen.</translation>
    </message>
    <message>
        <source>Export the site …</source>
        <translation>Standort exportieren …</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n session(s)</source>
        <translation>
            <numerusform>%1 von %n Sitzung</numerusform>
            <numerusform>%1 von %n Sitzungen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Aufbewahrt in %1</translation>
    </message>
    <message>
        <source>When it was made</source>
        <translation>Wann sie erstellt wurde</translation>
    </message>
    <message>
        <source>Just now: it holds</source>
        <translation>Gerade eben: in Ordnung</translation>
    </message>
    <message>
        <source>Just now: damaged</source>
        <translation>Gerade eben: beschädigt</translation>
    </message>
    <message>
        <source>The restore must end first.</source>
        <translation>Zuerst muss das Wiederherstellen enden.</translation>
    </message>
    <message>
        <source>The task that you started goes on.</source>
        <translation>Die gestartete Aufgabe läuft weiter.</translation>
    </message>
    <message>
        <source>Looking at the storage …</source>
        <translation>Speicher wird geprüft …</translation>
    </message>
    <message>
        <source>The storage could not be looked at.</source>
        <translation>Der Speicher konnte nicht geprüft werden.</translation>
    </message>
    <message>
        <source>Where to export to</source>
        <translation>Wohin exportieren</translation>
    </message>
    <message>
        <source>Where backups are kept</source>
        <translation>Ordner für Sicherungen</translation>
    </message>
    <message>
        <source>The backup is made and checked: %1 in %2.</source>
        <translation>Die Sicherung ist erstellt und geprüft: %1 in %2.</translation>
    </message>
    <message>
        <source>The site is exported and checked: %1 in %2.</source>
        <translation>Der Standort ist exportiert und geprüft: %1 in %2.</translation>
    </message>
    <message>
        <source>The backup was stopped; nothing of it was kept.</source>
        <translation>Die Sicherung wurde abgebrochen; nichts davon wurde behalten.</translation>
    </message>
    <message>
        <source>The export was stopped; nothing of it was kept.</source>
        <translation>Der Export wurde abgebrochen; nichts davon wurde behalten.</translation>
    </message>
    <message>
        <source>There is no new backup.</source>
        <translation>Es gibt keine neue Sicherung.</translation>
    </message>
    <message>
        <source>The site was not exported.</source>
        <translation>Der Standort wurde nicht exportiert.</translation>
    </message>
    <message>
        <source>Making a backup …</source>
        <translation>Sicherung wird erstellt …</translation>
    </message>
    <message>
        <source>Exporting the site …</source>
        <translation>Standort wird exportiert …</translation>
    </message>
    <message>
        <source>Verifying everything …</source>
        <translation>Alles wird geprüft …</translation>
    </message>
    <message>
        <source>Checking the backup …</source>
        <translation>Sicherung wird geprüft …</translation>
    </message>
    <message>
        <source>Restoring the backup. The present database is kept aside.</source>
        <translation>Die Sicherung wird wiederhergestellt. Die jetzige Datenbank bleibt beiseite erhalten.</translation>
    </message>
    <message>
        <source>Nothing was restored. The present database is as it was.</source>
        <translation>Es wurde nichts wiederhergestellt. Die jetzige Datenbank ist unverändert.</translation>
    </message>
    <message>
        <source>The present database could not be opened again.</source>
        <translation>Die jetzige Datenbank konnte nicht wieder geöffnet werden.</translation>
    </message>
    <message>
        <source>The backup is restored. The database that was here before is kept as %1. Please log in again.</source>
        <translation>Die Sicherung ist wiederhergestellt. Die bisherige Datenbank bleibt als %1 erhalten. Bitte melden Sie sich neu an.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StudiesScreen</name>
    <message>
        <source>Import a study</source>
        <translation>Studie einlesen</translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation>Studien (*.json)</translation>
    </message>
    <message>
        <source>The file could not be read.</source>
        <translation>Die Datei konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The study was not imported.</source>
        <translation>Die Studie wurde nicht eingelesen.</translation>
    </message>
    <message>
        <source>The study was not made.</source>
        <translation>Die Studie wurde nicht angelegt.</translation>
    </message>
    <message>
        <source>%1 is a new draft.</source>
        <translation>%1 ist ein neuer Entwurf.</translation>
    </message>
    <message>
        <source>%1 was not changed.</source>
        <translation>%1 wurde nicht geändert.</translation>
    </message>
    <message>
        <source>%1 is archived: nothing was deleted.</source>
        <translation>%1 ist archiviert: nichts wurde gelöscht.</translation>
    </message>
    <message>
        <source>%1 is back in the list.</source>
        <translation>%1 ist wieder in der Liste.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Close %1?</source>
        <translation>%1 schließen?</translation>
    </message>
    <message>
        <source>No more participants can be enrolled and no more runs begun; open runs can still be finished. This cannot be undone.</source>
        <translation>Es können keine Personen mehr aufgenommen und keine Läufe mehr begonnen werden; offene lassen sich noch beenden. Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Keep it open</source>
        <translation>Offen lassen</translation>
    </message>
    <message>
        <source>Close the study</source>
        <translation>Studie schließen</translation>
    </message>
    <message>
        <source>The study was not closed.</source>
        <translation>Die Studie wurde nicht geschlossen.</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Every study of this site. A draft is designed and tried with simulated observers. Frozen, its design can never be changed again: its SHA-256 stands in every export, and participants are enrolled under random codes.

New begins from a template or from nothing; Import reads a study from a JSON file. Return or a double click opens a study. Run takes a participant through it, Data shows what came of it.

Close ends enrolment for good. Archive takes a study out of the list and can be undone.</source>
        <translation>Alle Studien dieses Standorts. Ein Entwurf wird gestaltet und mit simulierten Beobachtern erprobt. Eingefroren ist er nie mehr zu ändern: sein SHA-256 steht in jedem Export, und Personen werden unter zufälligen Codes aufgenommen.

Neu beginnt mit einer Vorlage oder mit nichts; Einlesen liest eine Studie aus einer JSON-Datei. Eingabetaste oder Doppelklick öffnet eine Studie. Durchführen führt eine Person hindurch, Daten zeigt, was herauskam.

Schließen beendet die Aufnahme endgültig. Archivieren nimmt eine Studie aus der Liste und lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>New study …</source>
        <translation>Neue Studie …</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Einlesen …</translation>
    </message>
    <message>
        <source>Show archived ones</source>
        <translation>Archivierte zeigen</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Teilnehmende</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Close …</source>
        <translation>Schließen …</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivieren</translation>
    </message>
    <message>
        <source>Reading the studies …</source>
        <translation>Studien werden gelesen …</translation>
    </message>
    <message>
        <source>The studies could not be read</source>
        <translation>Die Studien konnten nicht gelesen werden</translation>
    </message>
    <message numerus="yes">
        <source>%n stud(y/ies)</source>
        <translation>
            <numerusform>%n Studie</numerusform>
            <numerusform>%n Studien</numerusform>
        </translation>
    </message>
    <message>
        <source>No studies yet</source>
        <translation>Noch keine Studien</translation>
    </message>
    <message>
        <source>Begin with a template: a ranking of three, a staircase or constant stimuli, ready to be changed.</source>
        <translation>Beginnen Sie mit einer Vorlage: einer Rangfolge von dreien, einer Treppe oder konstanten Reizen, bereit zum Ändern.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>%1 von %2 fertig</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Open the study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Choose a study in the list first.</source>
        <translation>Wählen Sie zuerst eine Studie in der Liste.</translation>
    </message>
    <message>
        <source>The design is still a draft: freeze it first.</source>
        <translation>Noch ist es ein Entwurf: Frieren Sie ihn zuerst ein.</translation>
    </message>
    <message>
        <source>The study is archived: bring it back first.</source>
        <translation>Die Studie ist archiviert: Holen Sie sie zuerst zurück.</translation>
    </message>
    <message>
        <source>The study is closed already.</source>
        <translation>Die Studie ist bereits geschlossen.</translation>
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
        <translation>Entblinden …</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Als CSV exportieren</translation>
    </message>
    <message>
        <source>Write a PDF</source>
        <translation>PDF schreiben</translation>
    </message>
    <message>
        <source>Export as BIDS</source>
        <translation>Als BIDS exportieren</translation>
    </message>
    <message>
        <source>Where should the folder go?</source>
        <translation>Wohin soll der Ordner?</translation>
    </message>
    <message>
        <source>Writing the tables …</source>
        <translation>Die Tabellen werden geschrieben …</translation>
    </message>
    <message>
        <source>The tables were written to %1.</source>
        <translation>Die Tabellen liegen jetzt in %1.</translation>
    </message>
    <message>
        <source>The tables could not be written.</source>
        <translation>Die Tabellen konnten nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Writing the BIDS dataset …</source>
        <translation>Der BIDS-Datensatz wird geschrieben …</translation>
    </message>
    <message>
        <source>The BIDS dataset was written to %1.</source>
        <translation>Der BIDS-Datensatz liegt jetzt in %1.</translation>
    </message>
    <message>
        <source>The BIDS dataset could not be written.</source>
        <translation>Der BIDS-Datensatz konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The report was written to %1.</source>
        <translation>Der Bericht liegt in %1.</translation>
    </message>
    <message>
        <source>The report could not be written.</source>
        <translation>Der Bericht konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Reading the studies …</source>
        <translation>Studien werden gelesen …</translation>
    </message>
    <message>
        <source>The studies could not be read</source>
        <translation>Die Studien konnten nicht gelesen werden</translation>
    </message>
    <message>
        <source>No data yet</source>
        <translation>Noch keine Daten</translation>
    </message>
    <message>
        <source>Data come from frozen studies that participants took part in.</source>
        <translation>Daten kommen von eingefrorenen Studien, an denen Personen teilgenommen haben.</translation>
    </message>
    <message>
        <source>Open the studies</source>
        <translation>Studien öffnen</translation>
    </message>
    <message>
        <source>Analysing the runs …</source>
        <translation>Läufe werden ausgewertet …</translation>
    </message>
    <message>
        <source>The study could not be analysed</source>
        <translation>Die Studie konnte nicht ausgewertet werden</translation>
    </message>
    <message>
        <source>Views of the data</source>
        <translation>Ansichten der Daten</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>SHA-256 %1</source>
        <translation>SHA-256 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n scored trial(s)</source>
        <translation>
            <numerusform>%n gewerteter Durchgang</numerusform>
            <numerusform>%n gewertete Durchgänge</numerusform>
        </translation>
    </message>
    <message>
        <source>unblinded</source>
        <translation>entblindet</translation>
    </message>
    <message>
        <source>blind: conditions by sealed codes</source>
        <translation>blind: Bedingungen unter versiegelten Codes</translation>
    </message>
    <message>
        <source>What came of a study.

Group shows each participant&apos;s Weber fraction with its interval, condition by condition, and warnings in words. Person shows a run&apos;s curve with its data. Trials lists every presentation with its fidelity; what did not count says why. Questions sums up the questionnaires.

Export writes tables (CSV), a BIDS dataset or a PDF; the design&apos;s SHA-256 is in each. While the experimenter is blind, conditions go by sealed codes, and nothing is shown of their runs but how well trials went, by participant; unblinding asks for a reason, is recorded and cannot be undone.</source>
        <translation>Was bei einer Studie herauskam.

Gruppe zeigt den Weber-Bruch jeder Person mit seinem Intervall, Bedingung für Bedingung, und Warnungen in Worten. Person zeigt die Kurve eines Laufs mit ihren Daten. Durchgänge führt jede Darbietung mit ihrer Wiedergabetreue auf; was nicht zählte, sagt warum. Fragen fasst die Fragebögen zusammen.

Exportiert werden Tabellen (CSV), ein BIDS-Datensatz oder ein PDF; in jedem steht der SHA-256 des Entwurfs. Solange die Versuchsleitung blind ist, stehen Bedingungen unter versiegelten Codes, und von ihren Läufen ist nur zu sehen, wie gut die Durchgänge jeder Person liefen; das Entblinden verlangt einen Grund, wird festgehalten und lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Groups hold runs that were shown, not felt</source>
        <translation>Gruppen enthalten auch gezeigte, nicht gefühlte Läufe</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StudyScreen</name>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>One study. As long as it is a draft everything can be changed; what is complete is kept at once, Ctrl+Z takes a step back, and what is wrong is said above the page.

Conditions say what is compared, by which task and procedure. Preview lets simulated observers do the study and shows the precision to be expected, the trials and the time. Participants enrols people under random codes and records their consent.

Freeze fixes the design for good under its SHA-256; participants can be enrolled from then on.</source>
        <translation>Eine Studie. Solange sie Entwurf ist, lässt sich alles ändern; was vollständig ist, wird sofort behalten, Strg+Z nimmt einen Schritt zurück, und was nicht stimmt, steht über der Seite.

Bedingungen sagen, was verglichen wird, mit welcher Aufgabe und welchem Verfahren. Vorschau lässt simulierte Beobachter die Studie machen und zeigt, welche Genauigkeit, wie viele Durchgänge und wie viel Zeit zu erwarten sind. Teilnehmende nimmt Personen unter zufälligen Codes auf und hält ihre Einwilligung fest.

Einfrieren legt den Entwurf unter seinem SHA-256 endgültig fest; von da an können Personen aufgenommen werden.</translation>
    </message>
    <message>
        <source>Reading the study …</source>
        <translation>Studie wird gelesen …</translation>
    </message>
    <message>
        <source>The study could not be read</source>
        <translation>Die Studie konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>Parts of the study</source>
        <translation>Teile der Studie</translation>
    </message>
    <message>
        <source>About</source>
        <translation>Über</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Vorschau</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Teilnehmende</translation>
    </message>
    <message>
        <source>Freeze …</source>
        <translation>Einfrieren …</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Einlesen …</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Save as JSON …</source>
        <translation>Als JSON speichern …</translation>
    </message>
    <message>
        <source>Language of the texts</source>
        <translation>Sprache der Texte</translation>
    </message>
    <message numerus="yes">
        <source>… and %n more</source>
        <translation>
            <numerusform>… und %n weitere</numerusform>
            <numerusform>… und %n weitere</numerusform>
        </translation>
    </message>
    <message>
        <source>Not kept yet, because this is not right:
%1</source>
        <translation>Noch nicht behalten, weil dies nicht stimmt:
%1</translation>
    </message>
    <message>
        <source>The draft could not be kept.
%1</source>
        <translation>Der Entwurf konnte nicht behalten werden.
%1</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>Kennung %1</translation>
    </message>
    <message>
        <source>SHA-256 %1</source>
        <translation>SHA-256 %1</translation>
    </message>
    <message>
        <source>frozen %1</source>
        <translation>eingefroren %1</translation>
    </message>
    <message>
        <source>unblinded</source>
        <translation>entblindet</translation>
    </message>
    <message>
        <source>blind</source>
        <translation>blind</translation>
    </message>
    <message>
        <source>everything is kept</source>
        <translation>alles ist behalten</translation>
    </message>
    <message>
        <source>keeping …</source>
        <translation>wird behalten …</translation>
    </message>
    <message>
        <source>not kept</source>
        <translation>nicht behalten</translation>
    </message>
    <message>
        <source>The draft could not be kept.</source>
        <translation>Der Entwurf konnte nicht behalten werden.</translation>
    </message>
    <message>
        <source>Leave without the last changes?</source>
        <translation>Ohne die letzten Änderungen gehen?</translation>
    </message>
    <message>
        <source>The design is not right yet, so its last changes are not kept. What was right before is.</source>
        <translation>Der Entwurf stimmt noch nicht, darum sind seine letzten Änderungen nicht behalten. Was vorher stimmte, ist es.</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Take the design of a file</source>
        <translation>Entwurf aus einer Datei übernehmen</translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation>Studien (*.json)</translation>
    </message>
    <message>
        <source>The file was not taken:
%1</source>
        <translation>Die Datei wurde nicht übernommen:
%1</translation>
    </message>
    <message>
        <source>Import of a file</source>
        <translation>Einlesen einer Datei</translation>
    </message>
    <message>
        <source>Save the design</source>
        <translation>Entwurf speichern</translation>
    </message>
    <message>
        <source>The design was not saved.</source>
        <translation>Der Entwurf wurde nicht gespeichert.</translation>
    </message>
    <message>
        <source>The design is saved in %1.</source>
        <translation>Der Entwurf liegt in %1.</translation>
    </message>
    <message>
        <source>The design has to be right before it can be frozen.</source>
        <translation>Der Entwurf muss fehlerfrei sein, bevor er eingefroren werden kann.</translation>
    </message>
    <message>
        <source>The last changes are still being kept.</source>
        <translation>Die letzten Änderungen werden noch gespeichert.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TargetBar</name>
    <message>
        <source>below the band</source>
        <translation>unter dem Bereich</translation>
    </message>
    <message>
        <source>in the band</source>
        <translation>im Bereich</translation>
    </message>
    <message>
        <source>above the band</source>
        <translation>über dem Bereich</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>über der Grenze</translation>
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
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Wird beendet …</translation>
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
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>What is recorded so far is kept and counts as stopped, not as completed. A new attempt begins at once.</source>
        <translation>Bisher Aufgezeichnetes bleibt erhalten und gilt als abgebrochen, nicht als abgeschlossen. Ein neuer Versuch beginnt sofort.</translation>
    </message>
    <message>
        <source>Start again from the beginning?</source>
        <translation>Von vorn neu beginnen?</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Depth of field (F)</source>
        <translation>Schärfentiefe (F)</translation>
    </message>
    <message>
        <source>Depth of field: this level keeps it on</source>
        <translation>Schärfentiefe: auf dieser Stufe immer an</translation>
    </message>
    <message>
        <source>Depth of field: this level keeps it off</source>
        <translation>Schärfentiefe: auf dieser Stufe immer aus</translation>
    </message>
    <message>
        <source>The picture is sharp at one distance only, as through a real endoscope</source>
        <translation>Das Bild ist nur in einer Entfernung scharf, wie durch ein echtes Endoskop</translation>
    </message>
    <message>
        <source>When the procedure is done the debrief opens by itself.</source>
        <translation>Nach dem Eingriff öffnet sich die Auswertung von selbst.</translation>
    </message>
    <message>
        <source>After the last trial the debrief opens by itself.</source>
        <translation>Nach dem letzten Durchgang öffnet sich die Auswertung von selbst.</translation>
    </message>
    <message>
        <source>Here you work. On the left you see the scene, on the right what is measured, below the controls. A level shows only what belongs to it; what is hidden is still recorded.

%1

Stop force takes force away at once and the clock stands still. Re-arm brings it back slowly. Pause keeps everything as it is. Start again keeps the attempt so far as stopped and begins a new one from the start.

%2</source>
        <translation>Hier arbeiten Sie. Links sehen Sie die Szene, rechts die Messwerte, unten die Bedienelemente. Eine Stufe zeigt nur, was zu ihr gehört; Verborgenes wird trotzdem aufgezeichnet.

%1

„Kraft stoppen“ nimmt die Kraft sofort weg, und die Uhr steht. „Freigeben“ bringt sie langsam zurück. „Pause“ lässt alles, wie es ist. „Neu beginnen“ bewahrt den bisherigen Versuch als abgebrochen auf und beginnt einen neuen von vorn.

%2</translation>
    </message>
    <message>
        <source>Start again from the beginning</source>
        <translation>Von vorn neu beginnen</translation>
    </message>
    <message>
        <source>Depth of field on or off</source>
        <translation>Schärfentiefe an oder aus</translation>
    </message>
    <message>
        <source>Select the next finding</source>
        <translation>Nächsten Fund wählen</translation>
    </message>
    <message>
        <source>Take the selected finding back</source>
        <translation>Gewählten Fund zurücknehmen</translation>
    </message>
    <message>
        <source>Nothing more to report</source>
        <translation>Nichts mehr zu melden</translation>
    </message>
    <message>
        <source>Free the pointer to rate with the mouse</source>
        <translation>Zeiger freigeben, um mit der Maus zu bewerten</translation>
    </message>
    <message>
        <source>Map: where, or how hard</source>
        <translation>Karte: wo oder wie fest</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TransportBar</name>
    <message>
        <source>To the beginning (Home)</source>
        <translation>Zum Anfang (Pos1)</translation>
    </message>
    <message>
        <source>One picture back (Left)</source>
        <translation>Ein Bild zurück (Links)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>One picture on (Right)</source>
        <translation>Ein Bild vor (Rechts)</translation>
    </message>
    <message>
        <source>To the end (End)</source>
        <translation>Zum Ende (Ende)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrialsPage</name>
    <message>
        <source>Order and blinding</source>
        <translation>Reihenfolge und Verblindung</translation>
    </message>
    <message>
        <source>Order of conditions</source>
        <translation>Reihenfolge der Bedingungen</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Blinding</source>
        <translation>Verblindung</translation>
    </message>
    <message>
        <source>Participants see no values or names</source>
        <translation>Teilnehmende: ohne Werte, Namen</translation>
    </message>
    <message>
        <source>Experimenters see sealed codes</source>
        <translation>Versuchsleitung: nur Codes</translation>
    </message>
    <message>
        <source>Trials and breaks</source>
        <translation>Durchgänge und Pausen</translation>
    </message>
    <message>
        <source>Rules of a trial</source>
        <translation>Regeln eines Durchgangs</translation>
    </message>
    <message>
        <source>Time to explore (0: any)</source>
        <translation>Zeit zum Erkunden (0: beliebig)</translation>
    </message>
    <message>
        <source>Time to answer (0: any)</source>
        <translation>Zeit zum Antworten (0: beliebig)</translation>
    </message>
    <message>
        <source>Between trials</source>
        <translation>Zwischen Durchgängen</translation>
    </message>
    <message>
        <source>Practice trials</source>
        <translation>Übungsdurchgänge</translation>
    </message>
    <message>
        <source>Break every (trials; 0: none)</source>
        <translation>Pause nach (Durchgängen; 0: keine)</translation>
    </message>
    <message>
        <source>Break of at least</source>
        <translation>Pause mindestens</translation>
    </message>
    <message>
        <source>Say whether an answer was right</source>
        <translation>Antwort bewerten</translation>
    </message>
    <message>
        <source>Masking sound</source>
        <translation>Maskierendes Geräusch</translation>
    </message>
    <message>
        <source>Show the objects, all alike</source>
        <translation>Objekte zeigen, alle gleich</translation>
    </message>
    <message>
        <source>Every object must be touched</source>
        <translation>Jedes Objekt berühren</translation>
    </message>
    <message>
        <source>Fidelity of a trial</source>
        <translation>Wiedergabetreue eines Durchgangs</translation>
    </message>
    <message>
        <source>A trial beyond these is not scored and presented again.</source>
        <translation>Ein Durchgang jenseits davon zählt nicht und wird noch einmal dargeboten.</translation>
    </message>
    <message>
        <source>Limits of fidelity</source>
        <translation>Grenzen der Wiedergabetreue</translation>
    </message>
    <message>
        <source>Force error, RMS</source>
        <translation>Kraftfehler, RMS</translation>
    </message>
    <message>
        <source>Error of the felt value (share)</source>
        <translation>Fehler des gefühlten Werts (Anteil)</translation>
    </message>
    <message>
        <source>Late ticks (share)</source>
        <translation>Verspätete Takte (Anteil)</translation>
    </message>
    <message>
        <source>Force at its limit (share)</source>
        <translation>Kraft an der Grenze (Anteil)</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>Mean speed</source>
        <translation>Mittlere Geschwindigkeit</translation>
    </message>
    <message>
        <source>Repeats of one trial at most</source>
        <translation>Höchstens Wiederholungen eines Durchgangs</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrialsPageOfRun</name>
    <message>
        <source>There are no runs yet.</source>
        <translation>Es gibt noch keine Läufe.</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Zählt</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>given</source>
        <translation>gegeben</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>falsch</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Number of the presentation</source>
        <translation>Nummer der Darbietung</translation>
    </message>
    <message>
        <source>How much more the object had</source>
        <translation>Um wie viel mehr der Gegenstand hatte</translation>
    </message>
    <message>
        <source>What the participant said</source>
        <translation>Was die Person sagte</translation>
    </message>
    <message>
        <source>Whether the trial counts, and why not</source>
        <translation>Ob der Durchgang zählt, und warum nicht</translation>
    </message>
    <message>
        <source>Time until the answer</source>
        <translation>Zeit bis zur Antwort</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>Mean speed of the tool</source>
        <translation>Mittlere Geschwindigkeit des Werkzeugs</translation>
    </message>
    <message>
        <source>Share of ticks that came late</source>
        <translation>Anteil verspäteter Takte</translation>
    </message>
    <message>
        <source>How far the felt value was from the one asked for</source>
        <translation>Wie weit der gefühlte Wert vom verlangten abwich</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Tempo (mm/s)</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Späte Takte</translation>
    </message>
    <message>
        <source>Felt off by</source>
        <translation>Abweichung</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrialsScreen</name>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>Person %1</translation>
    </message>
    <message>
        <source>Reading the study …</source>
        <translation>Studie wird gelesen …</translation>
    </message>
    <message>
        <source>Before you begin</source>
        <translation>Bevor Sie beginnen</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Participant %1 · practice</source>
        <translation>Person %1 · Übung</translation>
    </message>
    <message>
        <source>The next objects are coming. Lift the tool off.</source>
        <translation>Die nächsten Objekte kommen. Heben Sie das Instrument ab.</translation>
    </message>
    <message>
        <source>Force is coming. Hold still for a moment.</source>
        <translation>Die Kraft setzt ein. Halten Sie einen Moment still.</translation>
    </message>
    <message>
        <source>Right.</source>
        <translation>Richtig.</translation>
    </message>
    <message>
        <source>Not this time.</source>
        <translation>Diesmal nicht.</translation>
    </message>
    <message>
        <source>Touch every object first.</source>
        <translation>Berühren Sie zuerst jedes Objekt.</translation>
    </message>
    <message>
        <source>The time to explore is over. Answer now.</source>
        <translation>Die Zeit zum Erkunden ist um. Antworten Sie jetzt.</translation>
    </message>
    <message>
        <source>One moment …</source>
        <translation>Einen Moment …</translation>
    </message>
    <message>
        <source>A break</source>
        <translation>Eine Pause</translation>
    </message>
    <message numerus="yes">
        <source>Rest your hand. It can go on in %n second(s).</source>
        <translation>
            <numerusform>Ruhen Sie Ihre Hand aus. In %n Sekunde kann es weitergehen.</numerusform>
            <numerusform>Ruhen Sie Ihre Hand aus. In %n Sekunden kann es weitergehen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Whenever you are ready.</source>
        <translation>Wenn Sie bereit sind.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Please ask the experimenter</source>
        <translation>Bitte fragen Sie die Versuchsleitung</translation>
    </message>
    <message>
        <source>The last trial could not be shown well enough, several times.</source>
        <translation>Der letzte Durchgang konnte mehrmals nicht gut genug dargeboten werden.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Everything so far is kept.</source>
        <translation>Alles bisher ist behalten.</translation>
    </message>
    <message>
        <source>Thank you</source>
        <translation>Danke</translation>
    </message>
    <message>
        <source>This part is done.</source>
        <translation>Dieser Teil ist fertig.</translation>
    </message>
    <message>
        <source>The answer was not taken.</source>
        <translation>Die Antwort wurde nicht angenommen.</translation>
    </message>
    <message>
        <source>Stop this sitting?</source>
        <translation>Diese Sitzung anhalten?</translation>
    </message>
    <message>
        <source>Every answered trial is kept. It goes on later at the same trial.</source>
        <translation>Jeder beantwortete Durchgang ist behalten. Es geht später bei demselben Durchgang weiter.</translation>
    </message>
    <message>
        <source>Keep going</source>
        <translation>Weitermachen</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>This condition is completed.</source>
        <translation>Diese Bedingung ist abgeschlossen.</translation>
    </message>
    <message>
        <source>Every answered trial is kept. The run goes on at the same trial.</source>
        <translation>Jeder beantwortete Durchgang ist behalten. Der Lauf geht bei demselben Durchgang weiter.</translation>
    </message>
    <message>
        <source>The sitting could not be run</source>
        <translation>Die Sitzung konnte nicht durchgeführt werden</translation>
    </message>
    <message>
        <source>Experimenter&apos;s view</source>
        <translation>Ansicht der Versuchsleitung</translation>
    </message>
    <message>
        <source>Pause or go on</source>
        <translation>Pause oder weiter</translation>
    </message>
    <message>
        <source>Stop the sitting</source>
        <translation>Sitzung anhalten</translation>
    </message>
    <message>
        <source>How far this part is</source>
        <translation>Wie weit dieser Teil ist</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Masking sound on or off</source>
        <translation>Maskierendes Geräusch an oder aus</translation>
    </message>
    <message>
        <source>Experimenter (F2)</source>
        <translation>Versuchsleitung (F2)</translation>
    </message>
    <message>
        <source>Stop …</source>
        <translation>Anhalten …</translation>
    </message>
    <message>
        <source>Time to explore</source>
        <translation>Zeit zum Erkunden</translation>
    </message>
    <message>
        <source>Here a participant explores objects and answers.

The mouse moves the tool; the wheel or PageUp and PageDown raise and lower it. T frees the pointer, a click in the scene takes it again. Answers are given by the buttons, or by the keys that stand on them.

Space pauses. Esc stops force at once; R brings it back slowly, Esc once more asks whether to stop the sitting. F2 shows the experimenter&apos;s side: progress, estimate, fidelity of the last trial, and the button that spoils a trial. Every answered trial is kept; what is stopped goes on later at the same trial.</source>
        <translation>Hier erkundet eine Person Objekte und antwortet.

Die Maus bewegt das Instrument; Rad oder Bild auf und Bild ab heben und senken es. T gibt den Zeiger frei, ein Klick in die Szene nimmt ihn wieder. Geantwortet wird mit den Knöpfen oder den Tasten, die darauf stehen.

Die Leertaste macht Pause. Esc stoppt die Kraft sofort, R bringt sie langsam zurück; noch einmal Esc fragt, ob die Sitzung angehalten werden soll. F2 zeigt die Seite der Versuchsleitung: Fortschritt, Schätzung, Wiedergabetreue des letzten Durchgangs und den Knopf, der einen Durchgang verwirft. Jeder beantwortete Durchgang wird behalten; Angehaltenes geht später bei demselben Durchgang weiter.</translation>
    </message>
    <message>
        <source>Stop force</source>
        <translation>Kraft stoppen</translation>
    </message>
    <message>
        <source>Re-arm force</source>
        <translation>Kraft freigeben</translation>
    </message>
    <message>
        <source>The next one is coming. Lift the tool off.</source>
        <translation>Die nächste kommt. Heben Sie das Instrument ab.</translation>
    </message>
    <message>
        <source>%1 mm beside the highest point.</source>
        <translation>%1 mm neben dem höchsten Punkt.</translation>
    </message>
    <message>
        <source>Click or press Enter where it is highest.</source>
        <translation>Klicken Sie oder drücken Sie Enter, wo die Kugel am höchsten ist.</translation>
    </message>
    <message>
        <source>Feel for it first.</source>
        <translation>Tasten Sie erst danach.</translation>
    </message>
    <message>
        <source>The clock stands still and everything so far is kept.</source>
        <translation>Die Uhr steht und alles Bisherige bleibt erhalten.</translation>
    </message>
    <message>
        <source>Force is stopped</source>
        <translation>Kraft ist gestoppt</translation>
    </message>
    <message>
        <source>Re-arm (R)</source>
        <translation>Freigeben (R)</translation>
    </message>
    <message>
        <source>The sphere is too stiff for this device: %1 N/m are asked for, and at its delay it renders at most %2 N/m without trembling. Use a faster device, or plan a softer sphere in another study.</source>
        <translation>Die Kugel ist zu steif für dieses Gerät: Verlangt sind %1 N/m, und bei seiner Verzögerung gibt es ohne Zittern höchstens %2 N/m wieder. Nehmen Sie ein schnelleres Gerät, oder planen Sie in einer anderen Studie eine weichere Kugel.</translation>
    </message>
    <message>
        <source>Not with this device</source>
        <translation>Nicht mit diesem Gerät</translation>
    </message>
    <message>
        <source>Back to the participant</source>
        <translation>Zurück zur Person</translation>
    </message>
    <message>
        <source>This device renders none of the condition&apos;s differences at its delay. Use a faster or stronger device, or plan another reference in another study.</source>
        <translation>Dieses Gerät kann bei seiner Verzögerung keinen der Unterschiede dieser Bedingung darstellen. Verwenden Sie ein schnelleres oder stärkeres Gerät, oder planen Sie in einer anderen Studie eine andere Referenz.</translation>
    </message>
    <message>
        <source>This run was begun on a device that renders larger differences than this one. It goes on with such a device alone, so that all of its trials can be compared.</source>
        <translation>Dieser Lauf wurde mit einem Gerät begonnen, das größere Unterschiede darstellt als dieses. Er geht nur mit einem solchen Gerät weiter, damit alle seine Durchgänge vergleichbar sind.</translation>
    </message>
    <message>
        <source>This run was begun with another version of its procedure than this program has. A version never continues another one&apos;s run, so that all of its trials can be compared. What was answered is kept; enrol another participant for this condition.</source>
        <translation>Dieser Lauf wurde mit einer anderen Fassung seines Verfahrens begonnen, als dieses Programm hat. Keine Fassung setzt den Lauf einer anderen fort, damit alle Durchgänge vergleichbar bleiben. Was beantwortet wurde, bleibt erhalten; nehmen Sie für diese Bedingung jemand anderen auf.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::UnblindDialog</name>
    <message>
        <source>Unblind this study?</source>
        <translation>Diese Studie entblinden?</translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) are still to come. Whoever conducts their runs will no longer be blind.</source>
        <translation>
            <numerusform>%n teilnehmende Person kommt noch. Wer deren Läufe leitet, ist dann nicht mehr blind.</numerusform>
            <numerusform>%n Teilnehmende kommen noch. Wer deren Läufe leitet, ist dann nicht mehr blind.</numerusform>
        </translation>
    </message>
    <message>
        <source>Reason for unblinding</source>
        <translation>Grund für das Entblinden</translation>
    </message>
    <message>
        <source>Please name nobody: the reason is kept for ever.</source>
        <translation>Bitte nennen Sie niemanden: Der Grund bleibt für immer gespeichert.</translation>
    </message>
    <message>
        <source>Unblind</source>
        <translation>Entblinden</translation>
    </message>
    <message>
        <source>The study was not unblinded.
%1</source>
        <translation>Die Studie wurde nicht entblindet.
%1</translation>
    </message>
    <message>
        <source>From now on conditions go by their names, for everybody. It is recorded who unblinded it, when and why. This cannot be undone.</source>
        <translation>Von jetzt an heißen die Bedingungen bei ihren Namen, für alle. Festgehalten wird, wer wann und warum entblindet hat. Das lässt sich nicht rückgängig machen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::VoidDialog</name>
    <message>
        <source>Declare this session void</source>
        <translation>Diese Sitzung für ungültig erklären</translation>
    </message>
    <message>
        <source>Declare this session void?</source>
        <translation>Diese Sitzung für ungültig erklären?</translation>
    </message>
    <message>
        <source>Recording, scores and comments stay and can still be looked at. The session no longer counts for anything: no gate, no curve, no certificate. Your name and the reason are kept with it, and it cannot be taken back.</source>
        <translation>Aufzeichnung, Wertungen und Kommentare bleiben und können weiter angesehen werden. Die Sitzung zählt für nichts mehr: keine Anforderung, keine Kurve, kein Zertifikat. Ihr Name und die Begründung bleiben dabei gespeichert, und es lässt sich nicht zurücknehmen.</translation>
    </message>
    <message>
        <source>Reason (the trainee can read it)</source>
        <translation>Begründung (für die lernende Person lesbar)</translation>
    </message>
    <message>
        <source>Keep it as it is</source>
        <translation>So lassen</translation>
    </message>
    <message>
        <source>Declare void</source>
        <translation>Für ungültig erklären</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::VoidSessionDialog</name>
    <message>
        <source>Void a session</source>
        <translation>Sitzung für ungültig erklären</translation>
    </message>
    <message>
        <source>Void session %1 of %2?</source>
        <translation>Sitzung %1 von %2 für ungültig erklären?</translation>
    </message>
    <message>
        <source>It stays in the list with its recording and its scores, but no longer counts for anything. That it was voided, by whom and why is kept and cannot be taken back.</source>
        <translation>Sie bleibt mit Aufzeichnung und Wertungen in der Liste, zählt aber für nichts mehr. Dass sie für ungültig erklärt wurde, von wem und warum, bleibt gespeichert und lässt sich nicht zurücknehmen.</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>Begründung</translation>
    </message>
    <message>
        <source>For example: the device was not calibrated</source>
        <translation>Zum Beispiel: Das Gerät war nicht kalibriert</translation>
    </message>
    <message>
        <source>Keep it as it is</source>
        <translation>So lassen</translation>
    </message>
    <message>
        <source>Void the session</source>
        <translation>Für ungültig erklären</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::WithdrawDialog</name>
    <message>
        <source>Withdraw %1</source>
        <translation>%1 zurückziehen</translation>
    </message>
    <message>
        <source>The participant takes no further part; open runs are stopped. What was recorded stays under the code, and the place in the order is free again.</source>
        <translation>Die Person nimmt nicht weiter teil; offene Läufe werden angehalten. Aufgezeichnetes bleibt unter dem Code, und der Platz in der Reihenfolge wird wieder frei.</translation>
    </message>
    <message>
        <source>The participant wants the recordings erased</source>
        <translation>Die Person möchte, dass Aufzeichnungen gelöscht werden</translation>
    </message>
    <message>
        <source>The wish is kept; an administrator erases.</source>
        <translation>Der Wunsch wird festgehalten; ein Administrator löscht.</translation>
    </message>
    <message>
        <source>This cannot be undone.</source>
        <translation>Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Withdraw</source>
        <translation>Zurückziehen</translation>
    </message>
    <message>
        <source>The participant was not withdrawn.
%1</source>
        <translation>Die Person wurde nicht zurückgezogen.
%1</translation>
    </message>
    <message>
        <source>%1 takes no further part.</source>
        <translation>%1 nimmt nicht weiter teil.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::WorkspaceBox</name>
    <message>
        <source>Hand and workspace</source>
        <translation>Hand und Arbeitsraum</translation>
    </message>
    <message>
        <source>Movement of the tool for that of the hand</source>
        <translation>Bewegung des Instruments je Handbewegung</translation>
    </message>
    <message>
        <source>Shift to the right</source>
        <translation>Verschiebung nach rechts</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Shift away from you</source>
        <translation>Verschiebung von Ihnen weg</translation>
    </message>
    <message>
        <source>Shift up</source>
        <translation>Verschiebung nach oben</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Turn of the device&apos;s base to the left</source>
        <translation>Drehung der Gerätebasis nach links</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Tilt of the base away from you</source>
        <translation>Neigung der Basis von Ihnen weg</translation>
    </message>
    <message>
        <source>Tilt of the base to the right</source>
        <translation>Neigung der Basis nach rechts</translation>
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
    <name>chiron::scene3d::FlatComparison</name>
    <message>
        <source>Objects side by side and instrument, from above and from the side</source>
        <translation>Objekte nebeneinander und Instrument, von oben und von der Seite</translation>
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
        <translation>Objekte, Ziel und Instrument, von oben und von der Seite</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatPalpation</name>
    <message>
        <source>Height lines every %1 mm</source>
        <translation>Höhenlinien alle %1 mm</translation>
    </message>
    <message>
        <source>Tissue, fingers and findings, from above and from the side</source>
        <translation>Gewebe, Finger und Funde, von oben und von der Seite</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatTube</name>
    <message>
        <source>Elastic tube and instruments, from above and from the side</source>
        <translation>Elastischer Schlauch und Instrumente, von oben und von der Seite</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatUrethra</name>
    <message>
        <source>The endoscope&apos;s picture, and the canal from the side</source>
        <translation>Das Bild des Endoskops und der Kanal von der Seite</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::ForceGauge</name>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Tension (N)</source>
        <translation>Spannung (N)</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Quetschkraft (N)</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::MapLegend</name>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>Searched</source>
        <translation>Abgetastet</translation>
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
        <translation>unter %1 N</translation>
    </message>
    <message>
        <source>over %1 N</source>
        <translation>über %1 N</translation>
    </message>
    <message>
        <source>%1 (band)</source>
        <translation>%1 (Band)</translation>
    </message>
    <message>
        <source>not touched</source>
        <translation>nicht berührt</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::NoticePainter</name>
    <message>
        <source>The endoscope&apos;s picture is off at this level.</source>
        <translation>Das Bild des Endoskops ist auf dieser Stufe ausgeschaltet.</translation>
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
        <source>Drawn in two dimensions: 3D is switched off on this station.</source>
        <translation>2D-Darstellung: 3D ist an diesem Arbeitsplatz ausgeschaltet.</translation>
    </message>
    <message>
        <source>Drawn in two dimensions: OpenGL is not available here.</source>
        <translation>2D-Darstellung: OpenGL ist hier nicht verfügbar.</translation>
    </message>
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
        <source>%1 has no value (%2), pass mark %3</source>
        <translation>%1 hat keinen Wert (%2), Bestehensgrenze %3</translation>
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
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Error in locating the apex</source>
        <translation>Scheitelfehler</translation>
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
        <translation>Fehler in x (% des Radius)</translation>
    </message>
    <message>
        <source>Error in y (% of radius)</source>
        <translation>Fehler in y (% des Radius)</translation>
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
        <source>no mark: time was up</source>
        <translation>keine Markierung: Zeit war um</translation>
    </message>
    <message>
        <source>No trial was marked</source>
        <translation>Kein Durchgang wurde markiert</translation>
    </message>
    <message>
        <source>% error in locating virtual spheres</source>
        <translation>% Fehler beim Orten virtueller Kugeln</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>Error (% of radius)</source>
        <translation>Fehler (% des Radius)</translation>
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
    <message>
        <source>Off-centre and alignment over depth</source>
        <translation>Auslenkung und Ausrichtung über der Tiefe</translation>
    </message>
    <message>
        <source>Landmarks of the bladder seen</source>
        <translation>Gesehene Landmarken der Blase</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Distance from the middle of the canal</source>
        <translation>Auslenkung von der Mittellinie</translation>
    </message>
    <message>
        <source>Off-centre (mm)</source>
        <translation>Auslenkung (mm)</translation>
    </message>
    <message>
        <source>off-centre</source>
        <translation>Auslenkung</translation>
    </message>
    <message>
        <source>Angle between endoscope and canal</source>
        <translation>Winkel zwischen Endoskop und Kanal</translation>
    </message>
    <message>
        <source>Alignment (°)</source>
        <translation>Ausrichtung (°)</translation>
    </message>
    <message>
        <source>alignment</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>in</source>
        <translation>hinein</translation>
    </message>
    <message>
        <source>out</source>
        <translation>hinaus</translation>
    </message>
    <message>
        <source>bend</source>
        <translation>Biegung</translation>
    </message>
    <message>
        <source>bladder neck</source>
        <translation>Blasenhals</translation>
    </message>
    <message>
        <source>The endoscope did not enter</source>
        <translation>Das Endoskop wurde nicht eingeführt</translation>
    </message>
    <message>
        <source>Off-centre, largest in each millimetre</source>
        <translation>Auslenkung, größte je Millimeter</translation>
    </message>
    <message>
        <source>Alignment, largest in each millimetre</source>
        <translation>Ausrichtung, größter Winkel je Millimeter</translation>
    </message>
    <message>
        <source>Largest force on each place</source>
        <translation>Größte Kraft an jeder Stelle</translation>
    </message>
    <message>
        <source>Coverage: %1 % searched</source>
        <translation>Abdeckung: %1 % abgetastet</translation>
    </message>
    <message>
        <source>Lumps found: %1 of %2</source>
        <translation>Gefundene Knoten: %1 von %2</translation>
    </message>
    <message>
        <source>Findings reported: %1</source>
        <translation>Gemeldete Funde: %1</translation>
    </message>
    <message>
        <source>False alarms: %1</source>
        <translation>Falsche Alarme: %1</translation>
    </message>
    <message>
        <source>not touched</source>
        <translation>nicht berührt</translation>
    </message>
    <message>
        <source>under %1 N: not searched</source>
        <translation>unter %1 N: nicht abgetastet</translation>
    </message>
    <message>
        <source>%1 N or more: searched</source>
        <translation>ab %1 N: abgetastet</translation>
    </message>
    <message>
        <source>%1 to %2 N: below the band</source>
        <translation>%1 bis %2 N: unter dem Band</translation>
    </message>
    <message>
        <source>%1 to %2 N: in the band</source>
        <translation>%1 bis %2 N: im Band</translation>
    </message>
    <message>
        <source>%1 to %2 N: above the band</source>
        <translation>%1 bis %2 N: über dem Band</translation>
    </message>
    <message>
        <source>over %1 N: too hard</source>
        <translation>über %1 N: zu fest</translation>
    </message>
    <message>
        <source>lump, found (to scale)</source>
        <translation>Knoten, gefunden (maßstäblich)</translation>
    </message>
    <message>
        <source>lump, missed (to scale)</source>
        <translation>Knoten, übersehen (maßstäblich)</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>Fund</translation>
    </message>
    <message>
        <source>finding: hit</source>
        <translation>Fund: Treffer</translation>
    </message>
    <message>
        <source>finding: false alarm</source>
        <translation>Fund: falscher Alarm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>near side</source>
        <translation>vordere Seite</translation>
    </message>
    <message>
        <source>✓ hit</source>
        <translation>✓ Treffer</translation>
    </message>
    <message>
        <source>✗ false alarm</source>
        <translation>✗ falscher Alarm</translation>
    </message>
    <message>
        <source>✗ missed lump</source>
        <translation>✗ übersehener Knoten</translation>
    </message>
    <message>
        <source>too few regions: %1 with a lump, %2 without</source>
        <translation>zu wenige Felder: %1 mit Knoten, %2 ohne</translation>
    </message>
    <message>
        <source>%1 (95 %: %2 to %3)</source>
        <translation>%1 (95 %: %2 bis %3)</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>Lumps found</source>
        <translation>Gefundene Knoten</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>Falsche Alarme</translation>
    </message>
    <message>
        <source>Regions: hits, false alarms</source>
        <translation>Felder: Treffer, falsche Alarme</translation>
    </message>
    <message>
        <source>%1 of %2, %3 of %4</source>
        <translation>%1 von %2, %3 von %4</translation>
    </message>
    <message>
        <source>Sensitivity d′</source>
        <translation>Empfindlichkeit d′</translation>
    </message>
    <message>
        <source>Criterion c</source>
        <translation>Kriterium c</translation>
    </message>
    <message>
        <source>Nothing was reported, and nothing was there</source>
        <translation>Nichts wurde gemeldet, und nichts war da</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>x, y (mm)</source>
        <translation>x, y (mm)</translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation>Radius (mm)</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Error (mm)</source>
        <translation>Fehler (mm)</translation>
    </message>
    <message>
        <source>Trial %1, ended by time</source>
        <translation>Durchgang %1, Zeit abgelaufen</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>Durchgang %1</translation>
    </message>
    <message>
        <source>No trial was begun</source>
        <translation>Kein Durchgang wurde begonnen</translation>
    </message>
    <message>
        <source>✓ done</source>
        <translation>✓ fertig</translation>
    </message>
    <message>
        <source>✗ time was up</source>
        <translation>✗ Zeit war um</translation>
    </message>
    <message>
        <source>✗ torn</source>
        <translation>✗ gerissen</translation>
    </message>
    <message>
        <source>✗ could not be done any more</source>
        <translation>✗ nicht mehr möglich</translation>
    </message>
    <message>
        <source>not finished</source>
        <translation>nicht beendet</translation>
    </message>
    <message>
        <source>Tension of the tube</source>
        <translation>Spannung des Schlauchs</translation>
    </message>
    <message>
        <source>Tension (N)</source>
        <translation>Spannung (N)</translation>
    </message>
    <message>
        <source>band, from</source>
        <translation>Bereich, ab</translation>
    </message>
    <message>
        <source>band, to</source>
        <translation>Bereich, bis</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>How far the tube was stretched</source>
        <translation>Wie weit der Schlauch gedehnt wurde</translation>
    </message>
    <message>
        <source>Stretch (mm)</source>
        <translation>Dehnung (mm)</translation>
    </message>
    <message>
        <source>mark, from</source>
        <translation>Marke, ab</translation>
    </message>
    <message>
        <source>mark, to</source>
        <translation>Marke, bis</translation>
    </message>
    <message>
        <source>over-stretched</source>
        <translation>überdehnt</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Tension error</source>
        <translation>Fehler der Spannung</translation>
    </message>
    <message>
        <source>In the band</source>
        <translation>Im Bereich</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Größte Dehnung</translation>
    </message>
    <message>
        <source>Over-stretches</source>
        <translation>Überdehnungen</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Fallengelassen</translation>
    </message>
    <message>
        <source>Largest squeeze of each trial</source>
        <translation>Größte Quetschkraft jedes Durchgangs</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Quetschkraft (N)</translation>
    </message>
    <message>
        <source>squeeze</source>
        <translation>Quetschkraft</translation>
    </message>
    <message>
        <source>Where the objects lay at the end</source>
        <translation>Wo die Objekte am Ende lagen</translation>
    </message>
    <message>
        <source>From the target in x (mm)</source>
        <translation>Vom Ziel in x (mm)</translation>
    </message>
    <message>
        <source>From the target in y (mm)</source>
        <translation>Vom Ziel in y (mm)</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>set down</source>
        <translation>abgelegt</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>nicht fertig</translation>
    </message>
    <message>
        <source>Largest squeeze</source>
        <translation>Größte Quetschkraft</translation>
    </message>
    <message>
        <source>Squeezed too hard</source>
        <translation>Zu fest gequetscht</translation>
    </message>
    <message>
        <source>From the target</source>
        <translation>Vom Ziel</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Gewählt</translation>
    </message>
    <message>
        <source>never held</source>
        <translation>nie gehalten</translation>
    </message>
    <message>
        <source>✓ the heaviest</source>
        <translation>✓ das schwerste</translation>
    </message>
    <message>
        <source>✗ a lighter one</source>
        <translation>✗ ein leichteres</translation>
    </message>
    <message>
        <source>rendered to a scripted hand</source>
        <translation>an eine programmierte Hand ausgegeben</translation>
    </message>
    <message>
        <source>The session did not come to its end: these values are judged by no pass mark.</source>
        <translation>Die Sitzung kam nicht zu ihrem Ende: Diese Werte werden an keiner Bestehensgrenze gemessen.</translation>
    </message>
    <message>
        <source>No trial came to its end: there is no score.</source>
        <translation>Kein Durchgang kam zu seinem Ende: Es gibt keine Wertung.</translation>
    </message>
    <message>
        <source>Benchmark, chance</source>
        <translation>Referenz, Zufall</translation>
    </message>
    <message>
        <source>Tension and stretch</source>
        <translation>Spannung und Dehnung</translation>
    </message>
    <message>
        <source>Squeeze and place of each trial</source>
        <translation>Quetschkraft und Lage je Durchgang</translation>
    </message>
    <message>
        <source>Force of the tissue, and what was felt</source>
        <translation>Kraft des Gewebes und was davon gefühlt wurde</translation>
    </message>
    <message>
        <source>Ticks, late, left out</source>
        <translation>Takte, verspätet, ausgefallen</translation>
    </message>
    <message>
        <source>by chance %1</source>
        <translation>durch Zufall %1</translation>
    </message>
    <message>
        <source>The tissue answered with up to %1. Nothing of it was felt: the force was shown.</source>
        <translation>Das Gewebe antwortete mit bis zu %1. Gefühlt wurde davon nichts: Die Kraft wurde gezeigt.</translation>
    </message>
    <message>
        <source>The tissue answered with up to %1, and all of it was felt.</source>
        <translation>Das Gewebe antwortete mit bis zu %1, und alles davon wurde gefühlt.</translation>
    </message>
    <message>
        <source>The tissue answered with up to %1, of which at most %2 were felt: the force was limited for %3, the first time after %4.</source>
        <translation>Das Gewebe antwortete mit bis zu %1, davon wurden höchstens %2 gefühlt: Die Kraft war %3 lang begrenzt, zum ersten Mal nach %4.</translation>
    </message>
    <message>
        <source>%1 of the samples lie deeper or farther than the force law was checked for. Their force is bounded and counts, but it is less certain than the rest.</source>
        <translation>%1 der Messwerte liegen tiefer oder weiter, als das Kraftgesetz geprüft ist. Ihre Kraft ist begrenzt und zählt, ist aber weniger sicher als die übrigen.</translation>
    </message>
    <message>
        <source>felt (commanded)</source>
        <translation>gefühlt (ausgegeben)</translation>
    </message>
    <message>
        <source>Nothing was touched.</source>
        <translation>Nichts wurde berührt.</translation>
    </message>
    <message>
        <source>Pull on the fold of tissue</source>
        <translation>Zug an der Gewebefalte</translation>
    </message>
    <message>
        <source>Pull (N)</source>
        <translation>Zug (N)</translation>
    </message>
    <message>
        <source>pull</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>Retraction in the band</source>
        <translation>Zug der Falte im Zielbereich</translation>
    </message>
    <message>
        <source>Critical errors</source>
        <translation>Kritische Fehler</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>critical error</source>
        <translation>kritischer Fehler</translation>
    </message>
    <message>
        <source>Position of the tool tips, x</source>
        <translation>Position der Instrumentenspitzen, x</translation>
    </message>
    <message>
        <source>Position of the tool tips, y</source>
        <translation>Position der Instrumentenspitzen, y</translation>
    </message>
    <message>
        <source>Position of the tool tips, z</source>
        <translation>Position der Instrumentenspitzen, z</translation>
    </message>
    <message>
        <source>Force of the tissue on each tool (assessed)</source>
        <translation>Kraft des Gewebes auf jedes Instrument (gewertet)</translation>
    </message>
    <message>
        <source>Force felt (commanded) on each tool</source>
        <translation>Gefühlte (ausgegebene) Kraft an jedem Instrument</translation>
    </message>
    <message>
        <source>Force measured on each tool</source>
        <translation>Gemessene Kraft an jedem Instrument</translation>
    </message>
    <message>
        <source>Speed of the tool tips</source>
        <translation>Geschwindigkeit der Instrumentenspitzen</translation>
    </message>
</context>
</TS>
