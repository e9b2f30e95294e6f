package org.urbi.sim.device;

import static org.urbi.sim.SimulationException.ready;

import org.jspecify.annotations.Nullable;
import org.urbi.sim.SimulationException;
import org.urbi.sim.world.Drive;
import org.urbi.sim.world.SimulatedWorld;
import urbi.UBlendType;
import urbi.UDataType;
import urbi.UVar;

/**
 * A motor (manual, interface Motor). Its {@code val} is owned: what is written is the target, what
 * is read is sensed. {@code load}, from 0 to 1, is how much of its force the motor may use; {@code
 * torque} is what it exerts.
 */
abstract class SimMotor extends SimDevice {
  private static final double TURN = 2 * Math.PI;

  private final UVar val = new UVar();
  private final UVar turn = new UVar();
  private final UVar torque = new UVar();
  private @Nullable Drive drive;

  SimMotor(String name) {
    super(name);
  }

  @Override
  void bind(SimulatedWorld world, String deviceName) {
    Drive found = world.drive(deviceName);
    drive = found;
    requireFitting(found);
    UBindVars(val, "val", turn, "turn", torque, "torque");
    UOwned(val);
    val.blend.setValue(UBlendType.UMIX);
    getLoad().setValue(1);
    UNotifyChange(val, "targetChanged");
    UNotifyAccess(val, "refresh");
    UNotifyChange(getLoad(), "loadChanged");
  }

  /** Refuses a drive that is controlled in another way. */
  abstract void requireFitting(Drive found);

  final Drive drive() {
    return ready(drive);
  }

  final UVar val() {
    return val;
  }

  /** A new target. */
  public final void targetChanged(UVar target) {
    catchUp();
    double wanted = target.in();
    if (Double.isNaN(wanted) && target.type() != UDataType.DATA_DOUBLE) {
      throw new SimulationException(
          drive().name() + ": target: a number expected, not " + target.val());
    }
    drive().setTarget(wanted);
  }

  /** Another share of its force. */
  public final void loadChanged(UVar load) {
    catchUp();
    try {
      drive().setLoad(load.doubleValue());
    } catch (SimulationException e) {
      load.setValue(drive().load());
      throw e;
    }
  }

  @Override
  void updateSensors() {
    val.setValue(drive().sensed());
    turn.setValue(drive().joint().position() / TURN);
    torque.setValue(drive().joint().load());
  }

  final SimulationException wrongControl(String other) {
    return new SimulationException(
        drive().name()
            + " is driven by "
            + drive().control().name().toLowerCase()
            + ": use "
            + other);
  }
}
