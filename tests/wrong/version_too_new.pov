// A version of the language that does not exist yet.
#version 4.0;
sphere { 0, 1 }
