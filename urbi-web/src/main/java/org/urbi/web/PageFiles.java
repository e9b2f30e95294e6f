package org.urbi.web;

import io.netty.buffer.ByteBuf;
import io.netty.buffer.Unpooled;
import io.netty.channel.ChannelFutureListener;
import io.netty.channel.ChannelHandler;
import io.netty.channel.ChannelHandlerContext;
import io.netty.channel.SimpleChannelInboundHandler;
import io.netty.handler.codec.http.DefaultFullHttpResponse;
import io.netty.handler.codec.http.FullHttpRequest;
import io.netty.handler.codec.http.FullHttpResponse;
import io.netty.handler.codec.http.HttpHeaderNames;
import io.netty.handler.codec.http.HttpHeaderValues;
import io.netty.handler.codec.http.HttpHeaders;
import io.netty.handler.codec.http.HttpMethod;
import io.netty.handler.codec.http.HttpResponseStatus;
import io.netty.handler.codec.http.HttpUtil;
import io.netty.handler.codec.http.HttpVersion;
import io.netty.handler.codec.http.QueryStringDecoder;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * Serves the files of a page, which hold no secret, and passes on requests for the stream and for
 * what is offered as a download. Pages of other sites in the same browser get none of them: a
 * request must come from this page, and name it.
 */
final class PageFiles extends SimpleChannelInboundHandler<FullHttpRequest> {
  /** The path of the stream. */
  static final String STREAM = "/stream";

  /** By the end of its name, what a file is. */
  private static final Map<String, String> TYPES =
      Map.of("html", "text/html", "css", "text/css", "js", "text/javascript");

  /** A file in the folder of a page, or in one of its folders. */
  private static final Pattern FILE =
      Pattern.compile("(\\w[\\w-]*/)*\\w[\\w.-]*\\.(" + String.join("|", TYPES.keySet()) + ")");

  /** The folder of what all pages have, which is not beside their classes but beside this one. */
  private static final String SHARED = "shared/";

  /** A path of an annex: the name of its component, and what is asked for. */
  private static final Pattern ANNEX = Pattern.compile("/annex/(\\w+)(/.*)");

  private final Page page;
  private final PageShelf shelf;
  private final HostNames names;
  private final String scheme;
  private final Downloads downloads;
  private final Supplier<ChannelHandler> viewer;
  private final @Nullable Guests guests;
  private final @Nullable Entrance entrance;

  /**
   * @param shelf has the files
   * @param names by which it may be asked for
   * @param tls whether it is served by TLS
   * @param downloads what is offered besides
   * @param viewer makes what handles the stream of a browser
   * @param guests who else may come, or {@code null}
   * @param entrance to the annexes of the page, or {@code null}
   */
  PageFiles(
      Page page,
      PageShelf shelf,
      HostNames names,
      boolean tls,
      Downloads downloads,
      Supplier<ChannelHandler> viewer,
      @Nullable Guests guests,
      @Nullable Entrance entrance) {
    this.page = page;
    this.shelf = shelf;
    this.names = names;
    this.scheme = tls ? "https://" : "http://";
    this.downloads = downloads;
    this.viewer = viewer;
    this.guests = guests;
    this.entrance = entrance;
  }

  @Override
  protected void channelRead0(ChannelHandlerContext context, FullHttpRequest request)
      throws IOException {
    String path = new QueryStringDecoder(request.uri()).path();
    if (!request.decoderResult().isSuccess()) {
      answer(context, request, HttpResponseStatus.BAD_REQUEST);
    } else if (guests != null && isGuest(guests, request.headers())) {
      if (isForUs(request.headers(), guests.origins())) {
        String spoken = String.join(",", guests.subprotocols());
        become(context, request, "/", spoken, guests.longestMessage(), guests.handler().get());
      } else {
        refuse(context, request);
      }
    } else if (!isForUs(request.headers(), Set.of())) {
      refuse(context, request);
    } else if (path.equals(STREAM)) {
      become(context, request, STREAM, null, page.longestMessage(), viewer.get());
    } else if (path.startsWith(Downloads.FOLDER)) {
      deliver(context, request, path);
    } else {
      Matcher inside = ANNEX.matcher(path);
      Annex annex =
          entrance != null && inside.matches() ? entrance.annexes().find(inside.group(1)) : null;
      if (entrance == null || annex == null) {
        serve(context, request, page, path);
      } else if (inside.group(2).equals(STREAM)) {
        Page limits = annex.page();
        context.channel().config().setWriteBufferWaterMark(limits.backlog());
        ChannelHandler gate = entrance.gate().apply(annex);
        become(context, request, path, null, limits.longestMessage(), gate);
      } else {
        serve(context, request, annex.page(), inside.group(2));
      }
    }
  }

  /** Answers with a file that has been offered to whoever knows the path. */
  private void deliver(ChannelHandlerContext context, FullHttpRequest request, String path) {
    if (request.method() != HttpMethod.GET) {
      answer(context, request, HttpResponseStatus.METHOD_NOT_ALLOWED);
      return;
    }
    try {
      Path file = downloads.take(path, context.channel());
      if (file == null) {
        answer(
            context, request, HttpResponseStatus.NOT_FOUND, ": it is offered once, for a minute");
      } else {
        context.pipeline().replace(this, null, new Delivery(file));
      }
    } catch (Refused e) {
      answer(context, request, HttpResponseStatus.SERVICE_UNAVAILABLE, ": " + e.getMessage());
    } catch (IOException e) {
      answer(context, request, HttpResponseStatus.NOT_FOUND, ": the file cannot be read");
    }
  }

  /** Answers with a file of a page. */
  private void serve(ChannelHandlerContext context, FullHttpRequest request, Page from, String path)
      throws IOException {
    String file = path.equals("/") ? "index.html" : path.substring(Math.min(1, path.length()));
    if (!FILE.matcher(file).matches()) {
      answer(context, request, HttpResponseStatus.NOT_FOUND);
    } else if (request.method() != HttpMethod.GET && request.method() != HttpMethod.HEAD) {
      answer(context, request, HttpResponseStatus.METHOD_NOT_ALLOWED);
    } else {
      // Within this machine, what is sent costs less than what is packed and unpacked.
      boolean packed =
          !names.local()
              && request.headers().containsValue(HttpHeaderNames.ACCEPT_ENCODING, "gzip", true);
      Class<?> home = file.startsWith(SHARED) ? PageFiles.class : from.home();
      PageShelf.Served served = shelf.find(home, file, packed);
      if (served == null) {
        answer(context, request, HttpResponseStatus.NOT_FOUND);
      } else {
        // An annex is shown in a frame of this page.
        answer(context, request, served, type(file), from == page ? "'none'" : "'self'");
      }
    }
  }

  private static String type(String file) {
    return TYPES.get(file.substring(file.lastIndexOf('.') + 1)) + "; charset=utf-8";
  }

  /** With a file, unless the browser has it already. */
  private static void answer(
      ChannelHandlerContext context,
      FullHttpRequest request,
      PageShelf.Served served,
      String type,
      String frames) {
    boolean same = served.version().equals(request.headers().get(HttpHeaderNames.IF_NONE_MATCH));
    HttpResponseStatus status = same ? HttpResponseStatus.NOT_MODIFIED : HttpResponseStatus.OK;
    FullHttpResponse response = response(request, status, type, frames, served.content());
    response.headers().set(HttpHeaderNames.ETAG, served.version());
    response.headers().set(HttpHeaderNames.VARY, HttpHeaderNames.ACCEPT_ENCODING);
    if (served.packed()) {
      response.headers().set(HttpHeaderNames.CONTENT_ENCODING, HttpHeaderValues.GZIP);
    }
    send(context, request, response);
  }

  private static boolean isGuest(Guests guests, HttpHeaders headers) {
    return headers.contains(HttpHeaderNames.UPGRADE, HttpHeaderValues.WEBSOCKET, true)
        && guests.speak(headers.get(HttpHeaderNames.SEC_WEBSOCKET_PROTOCOL, ""));
  }

  /** Neither this nor the rest of HTTP is there for long: the stream replaces it. */
  private void become(
      ChannelHandlerContext context,
      FullHttpRequest request,
      String path,
      @Nullable String subprotocols,
      int longestMessage,
      ChannelHandler handler) {
    PagePort.serveStream(context.pipeline(), path, subprotocols, longestMessage, handler);
    context.fireChannelRead(request.retain());
    context.pipeline().remove(this);
  }

  private boolean isForUs(HttpHeaders headers, Set<String> others) {
    String host = headers.get(HttpHeaderNames.HOST, "");
    String origin = headers.get(HttpHeaderNames.ORIGIN);
    return names.allow(host)
        && (origin == null || origin.equalsIgnoreCase(scheme + host) || others.contains(origin));
  }

  /** Whoever has typed another name of the machine is told what to type. */
  private void refuse(ChannelHandlerContext context, FullHttpRequest request) {
    boolean named = names.allow(request.headers().get(HttpHeaderNames.HOST, ""));
    String hint = named ? "" : ": this page is not known by that name, use the address";
    answer(context, request, HttpResponseStatus.FORBIDDEN, hint);
  }

  private static void answer(
      ChannelHandlerContext context, FullHttpRequest request, HttpResponseStatus status) {
    answer(context, request, status, "");
  }

  private static void answer(
      ChannelHandlerContext context,
      FullHttpRequest request,
      HttpResponseStatus status,
      String hint) {
    byte[] text = (status + hint + "\n").getBytes(StandardCharsets.US_ASCII);
    send(
        context,
        request,
        response(request, status, "text/plain; charset=us-ascii", "'none'", text));
  }

  private static FullHttpResponse response(
      FullHttpRequest request,
      HttpResponseStatus status,
      String type,
      String frames,
      byte[] content) {
    boolean bare = request.method() == HttpMethod.HEAD || status == HttpResponseStatus.NOT_MODIFIED;
    ByteBuf body = bare ? Unpooled.EMPTY_BUFFER : Unpooled.wrappedBuffer(content);
    FullHttpResponse response = new DefaultFullHttpResponse(HttpVersion.HTTP_1_1, status, body);
    response
        .headers()
        .set(HttpHeaderNames.CONTENT_TYPE, type)
        .set(HttpHeaderNames.CONTENT_LENGTH, content.length)
        .set(HttpHeaderNames.CACHE_CONTROL, "no-cache")
        .set("x-content-type-options", "nosniff")
        .set("referrer-policy", "no-referrer")
        .set(
            HttpHeaderNames.CONTENT_SECURITY_POLICY,
            "default-src 'self'; img-src 'self' data:; media-src 'self' data:; base-uri 'none'; form-action 'none';"
                + " frame-ancestors "
                + frames);
    return response;
  }

  /** Whoever got something may go on. */
  private static void send(
      ChannelHandlerContext context, FullHttpRequest request, FullHttpResponse response) {
    boolean goesOn = HttpUtil.isKeepAlive(request) && response.status().code() < 400;
    HttpUtil.setKeepAlive(response, goesOn);
    if (goesOn) {
      context.writeAndFlush(response);
    } else {
      context.writeAndFlush(response).addListener(ChannelFutureListener.CLOSE);
    }
  }
}
