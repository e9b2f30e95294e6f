package org.urbi.sim.device;

import java.util.ArrayList;
import java.util.List;
import org.urbi.sim.SimulationException;
import org.urbi.sim.world.RobotDescription;
import urbi.UEvent;

/** What somebody who looks at a world wants of it. */
sealed interface WorldOrder {
  /** Time is to halt, or to go on. */
  record Pause(boolean wanted) implements WorldOrder {
    @Override
    public void carryOut(SimWorld world, UEvent driven) {
      world.pause(wanted);
    }
  }

  /** Time is to go on at another speed. */
  record Speed(double wanted) implements WorldOrder {
    @Override
    public void carryOut(SimWorld world, UEvent driven) {
      world.go(wanted);
    }
  }

  /** Some steps are to be gone on at once. */
  record Step(int count) implements WorldOrder {
    /** The most steps of one order, which holds the kernel meanwhile. */
    private static final int MOST = 1000;

    @Override
    public void carryOut(SimWorld world, UEvent driven) {
      if (count > MOST) {
        throw new SimulationException("step: at most " + MOST + " expected, not " + count);
      }
      world.step(count);
    }
  }

  /** Everything is to be as at the beginning. */
  record Reset() implements WorldOrder {
    @Override
    public void carryOut(SimWorld world, UEvent driven) {
      world.reset();
    }
  }

  /**
   * A body is to be hit.
   *
   * @param how a point, in metres, and by how much it is to be faster, in m/s
   */
  record Hit(String body, List<Double> how) implements WorldOrder {
    @Override
    public void carryOut(SimWorld world, UEvent driven) {
      world.hit(body, how.get(0), how.get(1), how.get(2), how.get(3), how.get(4), how.get(5));
    }
  }

  /**
   * The robot is to be driven: forward and to the left, each a share of its speed, from -1 to 1.
   */
  record Drive(double forward, double left) implements WorldOrder {
    /** What of the speed of its wheels a robot is driven at: at all of it, it would topple. */
    private static final double CAREFUL = 0.5;

    @Override
    public void carryOut(SimWorld world, UEvent driven) {
      RobotDescription robot =
          world
              .world()
              .robot()
              .filter(RobotDescription::mobile)
              .orElseThrow(
                  () -> new SimulationException("there is no robot on wheels in this world"));
      double fastest =
          CAREFUL * robot.radius() * Math.min(robot.left().maxSpeed(), robot.right().maxSpeed());
      driven.emit(
          fastest * Math.clamp(forward, -1, 1), fastest / robot.track() * Math.clamp(left, -1, 1));
    }
  }

  /**
   * Does it.
   *
   * @param driven what is emitted when the robot is to be driven
   * @throws SimulationException if it cannot be done
   */
  void carryOut(SimWorld world, UEvent driven);

  /**
   * Reads {@code pause 0}, {@code pause 1}, {@code speed FACTOR}, {@code step COUNT}, {@code
   * reset}, {@code drive FORWARD LEFT} or {@code hit X Y Z VX VY VZ BODY}.
   *
   * @throws SimulationException if it is none
   */
  static WorldOrder read(String text) {
    String[] words = text.split(" ", -1);
    return switch (words[0]) {
      case "pause" -> new Pause(numbers(words, 1).getFirst() != 0);
      case "speed" -> new Speed(numbers(words, 1).getFirst());
      case "step" -> new Step((int) (double) numbers(words, 1).getFirst());
      case "reset" -> new Reset();
      case "drive" -> {
        List<Double> shares = numbers(words, 2);
        yield new Drive(shares.getFirst(), shares.getLast());
      }
      case "hit" -> {
        List<Double> how = numbers(words, 6);
        yield new Hit(text.split(" ", 8).length == 8 ? text.split(" ", 8)[7] : "", how);
      }
      default -> throw new SimulationException("pause, speed, step, reset, drive or hit expected");
    };
  }

  /** So many numbers behind the first word. */
  private static List<Double> numbers(String[] words, int count) {
    List<Double> numbers = new ArrayList<>();
    for (int i = 1; i <= count; i++) {
      try {
        numbers.add(SimulationException.finite(Double.parseDouble(words[i]), words[0]));
      } catch (ArrayIndexOutOfBoundsException | NumberFormatException e) {
        throw new SimulationException(words[0] + ": " + count + " numbers expected", e);
      }
    }
    return numbers;
  }
}
