// sphere_sweep: a flat cubic curve seen square to its plane, half clear: two surfaces everywhere.
#version 3.7;
global_settings{assumed_gamma 1 max_trace_level 40}
camera{ orthographic location <0,0,-5> look_at 0 right 5.333*x up 4*y}
sphere_sweep { cubic_spline 5, <-1.5,-3,0>, .6, <-1,0,0>, .6, <0,.5,0>, .6, <1,0,0>, .6, <1.5,-3,0>, .6
	pigment { rgbt <.1,.1,.1,.9>} finish{diffuse 0 ambient 1} }
