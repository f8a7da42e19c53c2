// "and" is a single & here.
#version 3.7;
#declare A = 1;
#if (A > 0 && A < 2) sphere { 0, 1 } #end
