// A misspelt pattern.
#version 3.7;
sphere { 0, 1 pigment { agat scale 2 } }
