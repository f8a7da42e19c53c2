// A macro that returns its value as in C.
#version 3.7;
#macro Twice(A) return A*2; #end
sphere { 0, Twice(1) }
