// A macro called with too many arguments.
#macro Ball(Place) sphere { Place, 1 } #end
Ball(<0, 1, 0>, 2)
