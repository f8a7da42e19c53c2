// Settings of photons with a comma between them.
#version 3.7;
global_settings { assumed_gamma 1 photons { spacing .05, jitter 0 } }
sphere { 0, 1 pigment { rgb 1 } }
