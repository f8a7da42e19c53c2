// The remainder written as in C.
#version 3.7;
#declare I = 7;
#if (I % 2 = 0) sphere { 0, 1 } #end
