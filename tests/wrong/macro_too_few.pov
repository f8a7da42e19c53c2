// A macro called with too few arguments.
#macro Ball(Place, Size) sphere { Place, Size } #end
Ball(<0, 1, 0>)
