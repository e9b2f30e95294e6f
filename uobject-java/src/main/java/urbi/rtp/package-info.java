/**
 * Values of variables in datagrams (manual, "Using RTP transport in remote mode"; RFC 3550;
 * docs/protocol.md): cutting frames into datagrams, putting them together again, and both ends'
 * bookkeeping. Sockets and threads belong to those who use it.
 */
@NullMarked
package urbi.rtp;

import org.jspecify.annotations.NullMarked;
