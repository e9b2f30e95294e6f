package org.urbi.ros.two;

import java.io.IOException;
import java.nio.ByteBuffer;
import org.urbi.ros.rtps.Neighbourhood;
import org.urbi.ros.rtps.Participant;
import org.urbi.ros.rtps.ParticipantListener;
import org.urbi.ros.rtps.ParticipantOptions;
import org.urbi.ros.rtps.Reader;
import org.urbi.ros.rtps.ReaderListener;
import org.urbi.ros.rtps.Sample;
import org.urbi.ros.rtps.SampleIdentity;
import org.urbi.ros.rtps.Writer;
import org.urbi.ros.rtps.WriterListener;

/**
 * Offers {@code /bad}, a {@code std_srvs/Trigger}, and answers with half a message, or not at all.
 */
final class HostileServer implements AutoCloseable {
  private static final String TYPE = "std_srvs::srv::dds_::Trigger_";
  private static final byte[] NOTHING = {};

  volatile boolean goesOn = true;
  private final Participant participant;
  private final Writer writer;

  HostileServer(Neighbourhood domain) throws IOException {
    participant =
        Participant.open(ParticipantOptions.loopback(domain.domain()), ParticipantListener.NONE);
    writer =
        participant.writer(
            "rr/badReply", TYPE + "Response_", TwoServiceClient.QOS, NOTHING, WriterListener.NONE);
    participant.reader(
        "rq/badRequest", TYPE + "Request_", TwoServiceClient.QOS, NOTHING, new Requests());
  }

  private final class Requests implements ReaderListener {
    @Override
    public void available(Reader reader) {
      for (Sample each = reader.take(); each != null; each = reader.take()) {
        SampleIdentity asked = each.related();
        if (!goesOn || asked == null) continue;
        ByteBuffer half = ByteBuffer.wrap(new byte[] {0, 1, 0, 0, 1, 0, 0, 0, 100, 0, 0, 0, 'x'});
        writer.write(half, new SampleIdentity(asked.writer(), each.identity().sequence()));
      }
    }
  }

  @Override
  public void close() {
    participant.close();
  }
}
