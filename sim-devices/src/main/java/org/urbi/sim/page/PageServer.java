package org.urbi.sim.page;

import io.netty.channel.Channel;
import io.netty.channel.ChannelHandler;
import io.netty.channel.WriteBufferWaterMark;
import java.io.IOException;
import java.net.BindException;
import java.net.InetSocketAddress;
import org.urbi.sim.SimulationException;
import org.urbi.web.Annex;
import org.urbi.web.Gate;
import org.urbi.web.Page;
import org.urbi.web.PagePort;
import org.urbi.web.Refused;

/**
 * Serves the page of a world and its stream of snapshots, with one thread for all browsers. A slow
 * browser gets fewer snapshots; no browser delays the simulation.
 */
public final class PageServer implements AutoCloseable {
  private static final Page PAGE =
      new Page(PageServer.class, 1 << 10, 20, new WriteBufferWaterMark(1 << 16, 1 << 18));

  private static final int MAX_PORT = 65_535;

  private final PagePort served;
  private final Viewers viewers;
  private final Orders orders;

  /**
   * Begins to serve.
   *
   * @param host the address to listen on: {@code localhost} for this machine alone
   * @param port 0 for any that is free
   * @param setting what {@link WorldDescription#of} says of the world
   * @param orders takes what people at this machine want; others can only look
   * @throws SimulationException if it cannot listen there
   */
  public PageServer(String host, int port, String setting, Orders orders) {
    if (port < 0 || port > MAX_PORT) {
      throw new SimulationException(
          "page: port: between 0 and " + MAX_PORT + " expected, not " + port);
    }
    InetSocketAddress address = new InetSocketAddress(host, port);
    if (address.isUnresolved()) {
      throw new SimulationException("page: unknown host: " + host);
    }
    served = new PagePort("page", true);
    viewers = new Viewers(served.thread(), setting);
    this.orders = orders;
    String refusal =
        address.getAddress().isLoopbackAddress()
            ? ""
            : "This page also serves other machines: it can only be looked at.";
    try {
      served.listen(address, null, PAGE, () -> gate(refusal), null, null);
    } catch (IOException e) {
      throw new SimulationException(whyNot(host, port, e), e);
    }
    viewers.start();
  }

  /** Lets in whoever finds a place. */
  private Gate gate(String refusal) {
    return new Gate(ViewerHandler.WHERE) {
      @Override
      protected ChannelHandler admit(Channel channel, String uri) throws Refused {
        served.places().take(channel, refusal.isEmpty());
        return new ViewerHandler(viewers, orders, refusal);
      }
    };
  }

  /**
   * The page as a part of others, which decide who may intervene.
   *
   * @param title for people
   */
  public Annex annex(String title) {
    return new Annex(title, PAGE, refusal -> new ViewerHandler(viewers, orders, refusal));
  }

  private static String whyNot(String host, int port, IOException failure) {
    if (failure.getCause() instanceof BindException && port > 0) {
      return "page: cannot use port "
          + port
          + " of "
          + host
          + ": "
          + failure.getMessage()
          + "; another program may have it, choose another one (0: any that is free)";
    }
    return "page: cannot listen on " + host + ":" + port + ": " + failure.getMessage();
  }

  /** The port on which it listens. */
  public int port() {
    return served.port();
  }

  /** What to give to a browser. */
  public String url() {
    return served.url();
  }

  /** How many browsers are looking. */
  public int viewers() {
    return viewers.count();
  }

  /** Whether it is time to {@link #show} what there is now: somebody looks, and is ready. */
  public boolean isWaiting() {
    return viewers.isWaiting();
  }

  /** Shows a moment. Returns at once. */
  public void show(Snapshot moment) {
    viewers.show(moment);
  }

  /** Tells one browser why something could not be done; one that has left misses nothing. */
  public void tell(String viewer, String text) {
    viewers.tell(viewer, text);
  }

  /** Tells all browsers that the world, or what is shown of it, is another one. */
  public void describe(String setting) {
    viewers.describe(setting);
  }

  /** Leaves all browsers alone and frees the port. */
  @Override
  public void close() {
    viewers.close();
    served.close();
  }
}
