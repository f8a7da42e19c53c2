// What a sphere_sweep takes is told, not only what any object takes.
#version 3.7;
sphere_sweep { linear_spline 2, 0, 1, x, 1 strength 3 }
