/** Who is let in, and as what: tokens and roles (docs/networking.md). */
package org.urbi.server.trust;
