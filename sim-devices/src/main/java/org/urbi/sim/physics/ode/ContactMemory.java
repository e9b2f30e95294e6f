package org.urbi.sim.physics.ode;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import java.nio.ByteBuffer;
import org.urbi.sim.physics.Dynamics;
import org.urbi.sim.physics.Material;

/**
 * An array of ODE's {@code dContact}, laid out for 64 bits and double precision. It is read and
 * written as a buffer, which costs no native call.
 */
final class ContactMemory {
  /** {@code sizeof(dContact)}. */
  static final int SIZE = 248;

  /** Where the members are in it. */
  private static final int MODE = 0;

  private static final int MU = 8;
  private static final int RHO = 24;
  private static final int RHO2 = 32;
  private static final int RHO_N = 40;
  private static final int BOUNCE = 48;
  private static final int BOUNCE_VEL = 56;
  private static final int GEOM = 120;
  private static final int NORMAL = GEOM + 32;
  private static final int DEPTH = GEOM + 64;

  private static final int MODE_BOUNCE = 0x004;
  private static final int MODE_ROLLING = 0x400;

  /** Friction is in proportion to what presses: {@code dContactApprox1}. */
  private static final int MODE_PYRAMID = 0x7000;

  private final Memory memory = new Memory((long) SIZE * Dynamics.CONTACTS_PER_PAIR);
  private final ByteBuffer buffer = memory.getByteBuffer(0, memory.size());
  private final long address = Pointer.nativeValue(memory);

  ContactMemory() {
    memory.clear();
  }

  /** Where {@code dCollide} writes, every {@link #SIZE} bytes. */
  long geometry() {
    return address + GEOM;
  }

  long contact(int index) {
    return address + (long) index * SIZE;
  }

  /** Copies position, normal and depth of a contact. */
  void read(int index, double[] numbers) {
    int from = index * SIZE;
    int to = index * Dynamics.CONTACT_SIZE;
    for (int i = 0; i < 3; i++) {
      numbers[to + i] = buffer.getDouble(from + GEOM + 8 * i);
      numbers[to + 3 + i] = buffer.getDouble(from + NORMAL + 8 * i);
    }
    numbers[to + 6] = buffer.getDouble(from + DEPTH);
  }

  void setSurface(int index, Material material) {
    int at = index * SIZE;
    int mode = MODE_PYRAMID;
    buffer.putDouble(at + MU, material.friction());
    if (material.bounce() > 0) {
      mode |= MODE_BOUNCE;
      buffer.putDouble(at + BOUNCE, material.bounce());
      buffer.putDouble(at + BOUNCE_VEL, Material.SLOWEST_BOUNCE);
    }
    if (material.rolling() > 0) {
      mode |= MODE_ROLLING;
      buffer.putDouble(at + RHO, material.rolling());
      buffer.putDouble(at + RHO2, material.rolling());
      buffer.putDouble(at + RHO_N, material.rolling());
    }
    buffer.putInt(at + MODE, mode);
  }
}
