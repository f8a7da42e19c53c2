// Two equals signs compare in C.
#version 3.7;
#declare A = 1;
#if (A == 1) sphere { 0, 1 } #end
