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
