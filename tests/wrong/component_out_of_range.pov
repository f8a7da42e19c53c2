// The third component of a vector of two.
#declare V = <1, 2>;
sphere { 0, V.z }
