! A cantilever strip made of as many beams as a design variable says: variables, a macro, a loop.
!
defaults units  &
   length = mm  &
   angle = deg  &
   force = newton  &
   mass = kg  &
   time = sec
!
model create  &
   model_name = strip
!
variable create  &
   variable_name = .strip.segments  &
   integer_value = 6
variable create  &
   variable_name = .strip.span  &
   units = "length"  &
   real_value = 900.0
variable create  &
   variable_name = .strip.width  &
   units = "length"  &
   real_value = 30.0
variable create  &
   variable_name = .strip.height  &
   units = "length"  &
   real_value = 12.0
variable create  &
   variable_name = .strip.modulus  &
   units = "pressure"  &
   real_value = 7.1E+04
variable create  &
   variable_name = .strip.density  &
   units = "density"  &
   real_value = 2.74E-06
variable create  &
   variable_name = .strip.segment  &
   units = "length"  &
   real_value = (.strip.span / .strip.segments)
!
defaults coordinate_system  &
   default_coordinate_system = .strip.ground
!
marker create  &
   marker_name = .strip.ground.node_0  &
   location = 0.0, 0.0, 0.0
!
macro read  &
   macro_name = .strip.segment_macro  &
   file_name = "segment.mac"
!
variable create  &
   variable_name = .strip.last  &
   object_value = .strip.ground.node_0
!
for variable_name = i  start_value = 1  end_value = (.strip.segments)
   strip segment  index = (eval(i))  previous = (eval(.strip.last.object_value))
   variable modify  &
      variable_name = .strip.last  &
      object_value = (eval(".strip.node_" // RTOI(i) // ".cm"))
end
!
force create direct single_component_force  &
   single_component_force_name = .strip.tip_force  &
   type_of_freedom = translational  &
   action_only = on  &
   i_marker_name = (eval(.strip.last.object_value))  &
   j_marker_name = .strip.ground.node_0  &
   function = "0.5"
!
output_control create request  &
   request_name = .strip.TIP  &
   output_type = displacement  &
   i_marker_name = (eval(.strip.last.object_value))  &
   j_marker_name = .strip.ground.node_0
!
simulation single_run equilibrium  &
   model_name = .strip
!
! Every beam follows when one variable changes: an eighth of the stiffness.
variable modify  &
   variable_name = .strip.height  &
   real_value = 6.0
!
simulation single_run equilibrium  &
   model_name = .strip
