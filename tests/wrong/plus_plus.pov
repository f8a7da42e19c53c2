// A variable that grows as in C.
#version 3.7;
#declare I = 0;
#while (I < 3) sphere { I*x, 1 } I++; #end
