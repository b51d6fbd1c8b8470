! Cantilevers as chains of beams: `chain` builds one, the commands below load it.
macro read macro_name = make_chain file_name = "chain.mac"
!
! A force at the tip along global x, y and z: numbers or functions of time, N.
macro create macro_name = tip_force user_entered_command = "tip force" wrap_in_undo = no commands_to_be_executed =  &
   "!$x:t=string:d=0",  &
   "!$y:t=string:d=0",  &
   "!$z:t=string:d=0",  &
   "marker create marker_name = .chain.ground.along_x location = 0, 0, 0 orientation = 90, 90, 0",  &
   "marker create marker_name = .chain.ground.along_y location = 0, 0, 0 orientation = 180, 90, 0",  &
   "marker create marker_name = .chain.ground.along_z location = 0, 0, 0 orientation = 0, 0, 0",  &
   "tip component along = x size = \"$x\"",  &
   "tip component along = y size = \"$y\"",  &
   "tip component along = z size = \"$z\""
macro create macro_name = tip_component user_entered_command = "tip component" wrap_in_undo = no commands_to_be_executed =  &
   "!$along:t=list(x,y,z)",  &
   "!$size:t=string",  &
   "if condition = (\"$size\" != \"0\")",  &
   "   force create direct single_component_force single_component_force_name = .chain.force_$along type_of_freedom = translational action_only = on i_marker_name = (eval(.chain.tip)) j_marker_name = .chain.ground.along_$along function = \"$size\"",  &
   "end"
!
! A moment about z at the tip.
macro create macro_name = tip_moment user_entered_command = "tip moment" wrap_in_undo = no commands_to_be_executed =  &
   "!$size:t=real",  &
   "force create direct single_component_force single_component_force_name = .chain.moment type_of_freedom = rotational action_only = on i_marker_name = (eval(.chain.tip)) j_marker_name = .chain.ground.node_0 function = \"$size\""
!
! A torque about the x axis at the tip.
macro create macro_name = tip_torque user_entered_command = "tip torque" wrap_in_undo = no commands_to_be_executed =  &
   "!$size:t=real",  &
   "marker create marker_name = .chain.ground.along_x location = 0, 0, 0 orientation = 90, 90, 0",  &
   "force create direct single_component_force single_component_force_name = .chain.torque type_of_freedom = rotational action_only = on i_marker_name = (eval(.chain.tip)) j_marker_name = .chain.ground.along_x function = \"$size\""
