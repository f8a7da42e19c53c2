// Optional macro parameters are of a later version of the language.
#version 3.7;
#macro Ball(Place, optional Size) sphere { Place, 1 } #end
Ball(0, 2)
