<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>AccountWords</name>
    <message numerus="yes">
        <source>Try again in %n second(s)</source>
        <translation>
            <numerusform>Try again in %n second</numerusform>
            <numerusform>Try again in %n seconds</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message numerus="yes">
        <source>%n pass mark(s) of this level were not met:</source>
        <translation>
            <numerusform>%n pass mark of this level was not met:</numerusform>
            <numerusform>%n pass marks of this level were not met:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>The computer could not keep up and %n sample(s) were lost. The rest is kept and can be played back. It does not count towards passing; close other programs before the next attempt.</source>
        <translation>
            <numerusform>The computer could not keep up and %n sample was lost. The rest is kept and can be played back. It does not count towards passing; close other programs before the next attempt.</numerusform>
            <numerusform>The computer could not keep up and %n samples were lost. The rest is kept and can be played back. It does not count towards passing; close other programs before the next attempt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>chiron::desktop::InfoPanel</name>
    <message numerus="yes">
        <source>%n samples could not be recorded: this session will be incomplete.</source>
        <translation>
            <numerusform>%n sample could not be recorded: this session will be incomplete.</numerusform>
            <numerusform>%n samples could not be recorded: this session will be incomplete.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Recording complete; %n ticks late</source>
        <translation>
            <numerusform>Recording complete; %n tick late</numerusform>
            <numerusform>Recording complete; %n ticks late</numerusform>
        </translation>
    </message>
</context>
</TS>
