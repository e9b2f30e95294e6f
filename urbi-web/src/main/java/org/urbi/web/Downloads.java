package org.urbi.web;

import io.netty.channel.Channel;
import io.netty.channel.EventLoop;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * Files that somebody who has been let in may fetch. A link of a page cannot bring a token without
 * leaving it in the history of the browser: so each file is offered at an address that nobody can
 * guess, for a moment, and once. For the thread that serves all browsers.
 */
public final class Downloads {
  /** Below which the addresses are. */
  static final String FOLDER = "/download/";

  private static final int SECRET_BYTES = 16;
  private static final int SECONDS = 60;

  private final Map<String, Path> offered = new HashMap<>();
  private final EventLoop thread;
  private final Places places;

  /**
   * @param places of those who are served: whoever fetches a file has one until he has it
   */
  Downloads(EventLoop thread, Places places) {
    this.thread = thread;
    this.places = places;
  }

  /**
   * Offers a file to an owner.
   *
   * @return its address, to be asked for within a minute
   */
  public String offer(Path file) {
    byte[] secret = new byte[SECRET_BYTES];
    // Made here, because few servers need one, and it loads all security providers.
    new SecureRandom().nextBytes(secret);
    String address = FOLDER + HexFormat.of().formatHex(secret);
    offered.put(address, file);
    thread.schedule(() -> offered.remove(address), SECONDS, TimeUnit.SECONDS);
    return address;
  }

  /**
   * What is offered at an address, to the first one who asks; null if nothing is.
   *
   * @throws Refused if there is no place for him
   */
  @Nullable Path take(String address, Channel channel) throws Refused {
    Path file = offered.remove(address);
    if (file != null) {
      places.take(channel, true);
    }
    return file;
  }
}
