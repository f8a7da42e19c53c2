// A comment as in a shell.
#version 3.7;
# a red ball
sphere { 0, 1 pigment { rgb 1 } }
