package org.urbi.server.studio.access;

import io.netty.channel.Channel;
import io.netty.channel.ChannelHandler;
import org.urbi.kernel.trust.Role;
import org.urbi.web.Annex;
import org.urbi.web.Gate;
import org.urbi.web.Refused;

/** Lets a browser in to the stream of a component's page by its token, and then gives way to it. */
public final class AnnexGate extends Gate {
  private final Admission admission;
  private final Annex annex;

  public AnnexGate(Admission admission, Annex annex) {
    super("a page in the studio");
    this.admission = admission;
    this.annex = annex;
  }

  @Override
  protected ChannelHandler admit(Channel channel, String uri) throws Refused {
    Role role = admission.admit(uri, channel);
    return annex
        .viewer()
        .apply(role == Role.OBSERVER ? "You are an observer, who sees and cannot change." : "");
  }
}
