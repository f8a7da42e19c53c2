// More photons wanted at least than at most.
#version 3.7;
global_settings { assumed_gamma 1 photons { count 20000 gather 100, 20 } }
sphere { 0, 1 pigment { rgb 1 } }
