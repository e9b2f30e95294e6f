package org.urbi.ros.rtps;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.jspecify.annotations.Nullable;

/**
 * What a sample carries beside its payload.
 *
 * @param disposed whether its instance is no more
 * @param key the instance
 * @param related the sample that it answers
 */
record InlineQos(boolean disposed, @Nullable Guid key, @Nullable SampleIdentity related) {
  static final InlineQos NONE = new InlineQos(false, null, null);

  private static final int DISPOSED_OR_UNREGISTERED = 3;

  /** Reads the list that the datagram continues with, its end included. */
  static InlineQos read(ByteBuffer in) throws MalformedException {
    boolean disposed = false;
    Guid key = null;
    SampleIdentity related = null;
    ParameterReader parameters = new ParameterReader(in);
    while (parameters.next()) {
      ByteBuffer value = parameters.value();
      switch (parameters.id()) {
        case ParameterId.STATUS_INFO ->
            disposed = (Wire.bigEndian(value) & DISPOSED_OR_UNREGISTERED) != 0;
        case ParameterId.KEY_HASH -> key = Guid.read(value);
        case ParameterId.RELATED_SAMPLE_IDENTITY, ParameterId.RELATED_SAMPLE_IDENTITY_OF_FAST_DDS ->
            related = new SampleIdentity(Guid.read(value), signed(value));
        default -> {}
      }
    }
    return disposed || key != null || related != null
        ? new InlineQos(disposed, key, related)
        : NONE;
  }

  boolean isEmpty() {
    return !disposed && key == null && related == null;
  }

  void write(ByteBuffer out) {
    ParameterWriter parameters = new ParameterWriter(out);
    if (key != null) parameters.guid(ParameterId.KEY_HASH, key);
    if (disposed) {
      parameters.begin(ParameterId.STATUS_INFO);
      out.order(ByteOrder.BIG_ENDIAN)
          .putInt(DISPOSED_OR_UNREGISTERED)
          .order(ByteOrder.LITTLE_ENDIAN);
      parameters.end();
    }
    // The one of the specification, and the one that older peers look for.
    if (related != null) {
      related(parameters, out, ParameterId.RELATED_SAMPLE_IDENTITY, related);
      related(parameters, out, ParameterId.RELATED_SAMPLE_IDENTITY_OF_FAST_DDS, related);
    }
    parameters.finish();
  }

  private static void related(
      ParameterWriter parameters, ByteBuffer out, int id, SampleIdentity related) {
    parameters.begin(id);
    related.writer().write(out);
    Wire.putSequence(out, related.sequence());
    parameters.end();
  }

  /** A client names its reader in a request, whose number then is none, and may be anything. */
  private static long signed(ByteBuffer in) {
    return (long) in.getInt() << 32 | Wire.unsigned(in.getInt());
  }
}
