// A word that belongs elsewhere; too many could stand here to be listed.
#version 3.7;
sphere { 0, 1 pigment { bozo falloff 2 } }
