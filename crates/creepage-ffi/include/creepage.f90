! The C interface of creepage for Fortran; creepage.h says more. Compile it with your program:
!
!   gfortran $(pkg-config --variable=includedir creepage)/creepage.f90 program.f90 \
!     $(pkg-config --libs creepage)
module creepage
  use, intrinsic :: iso_c_binding
  implicit none

  integer(c_int32_t), parameter :: creepage_ok = 0, creepage_solved = 0, creepage_no_case = 8

  interface
    ! name, options: texts that end with c_null_char; a_over_b, poisson, kappa_over_mu (1).
    function creepage_theory_new(name, options, a_over_b, poisson, kappa_over_mu, theory, message, &
        message_size) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: name(*), options(*)
      real(c_double), value :: a_over_b, poisson, kappa_over_mu
      type(c_ptr), intent(out) :: theory
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      integer(c_int32_t) :: code
    end function

    subroutine creepage_theory_free(theory) bind(c)
      import
      type(c_ptr), value :: theory
    end subroutine

    ! creepages(3, n): xi, eta, chi (1); forces(3, n): f_x, f_y, m_z (1); statuses(n). errors of
    ! 3 n and derivatives of 9 n numbers: their addresses, or c_null_ptr.
    function creepage_theory_force(theory, count, creepages, forces, errors, derivatives, statuses, &
        message, message_size) bind(c) result(code)
      import
      type(c_ptr), value :: theory, errors, derivatives
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: creepages(3, *)
      real(c_double), intent(out) :: forces(3, *)
      integer(c_int32_t), intent(out) :: statuses(*)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      integer(c_int32_t) :: code
    end function

    ! creepage(3): longitudinal, lateral (1), spin (rad/m), given or found; force(3): longitudinal
    ! (N), lateral (N), moment (N m); theory: c_null_ptr for the file's own.
    function creepage_case_solve(path, theory, creepage, force, status, message, message_size) &
        bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), value :: theory
      real(c_double), intent(out) :: creepage(3), force(3)
      integer(c_int32_t), intent(out) :: status
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      integer(c_int32_t) :: code
    end function

    ! The case of a file, kept; theory: c_null_ptr for the file's own.
    function creepage_case_new(path, theory, made, message, message_size) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), value :: theory
      type(c_ptr), intent(out) :: made
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      integer(c_int32_t) :: code
    end function

    subroutine creepage_case_free(made) bind(c)
      import
      type(c_ptr), value :: made
    end subroutine

    ! values(m, n) of the m quantities, a text as 'longitudinal,normal_force'; forces(3, n): N, N,
    ! N m; statuses(n). table, dimensionless, errors, powers: addresses, or c_null_ptr.
    function creepage_case_force(made, table, quantities, count, values, forces, dimensionless, &
        errors, powers, statuses, message, message_size) bind(c) result(code)
      import
      type(c_ptr), value :: made, table, dimensionless, errors, powers
      character(kind=c_char), intent(in) :: quantities(*)
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: values(*)
      real(c_double), intent(out) :: forces(3, *)
      integer(c_int32_t), intent(out) :: statuses(*)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      integer(c_int32_t) :: code
    end function

    ! upper(4), lower(4): shear modulus (Pa), Poisson's ratio, radii along and across (m); angle
    ! (degrees); contact(9) as creepage.h says, in SI units.
    function creepage_hertz(upper, lower, angle, normal_force, contact, status, message, &
        message_size) bind(c) result(code)
      import
      real(c_double), intent(in) :: upper(4), lower(4)
      real(c_double), value :: angle, normal_force
      real(c_double), intent(out) :: contact(9)
      integer(c_int32_t), intent(out) :: status
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      integer(c_int32_t) :: code
    end function

    ! A contact map of `creepage map`.
    function creepage_map_load(path, map, message, message_size) bind(c) result(code)
      import
      character(kind=c_char), intent(in) :: path(*)
      type(c_ptr), intent(out) :: map
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      integer(c_int32_t) :: code
    end function

    subroutine creepage_map_free(map) bind(c)
      import
      type(c_ptr), value :: map
    end subroutine

    ! states(12, n): y, z, roll, yaw, axle load; speed, pitch rate, lateral, vertical velocity, roll,
    ! yaw rate; friction; NaN for what is the wheelset's own or found. answers(21, n): force (N) and
    ! moment (N m) on the left rail, on the right rail, on the wheelset; z, roll, pitch rate. errors of
    ! 4 n and derivatives of 96 n numbers: their addresses, or c_null_ptr.
    function creepage_map_solve(map, count, states, answers, errors, derivatives, message, &
        message_size) bind(c) result(code)
      import
      type(c_ptr), value :: map, errors, derivatives
      integer(c_size_t), value :: count
      real(c_double), intent(in) :: states(12, *)
      real(c_double), intent(out) :: answers(21, *)
      character(kind=c_char), intent(out) :: message(*)
      integer(c_size_t), value :: message_size
      integer(c_int32_t) :: code
    end function
  end interface
end module
