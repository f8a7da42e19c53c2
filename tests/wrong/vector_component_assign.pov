// One component of a vector set alone.
#version 3.7;
#declare V = <1, 2, 3>;
#declare V.x = 5;
sphere { V, 1 }
