# The exact forces on a rail and their error bars; the traction, adhesion and slip as a picture.
import creepage
solution = creepage.Case.from_toml("wheel-on-rail.toml").solve()
print(solution.force, solution.details)
print(solution.save("out"))
