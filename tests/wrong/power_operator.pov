// A power written with ^.
#version 3.7;
#declare f = function(x) { x^2 };
sphere { 0, f(1) }
