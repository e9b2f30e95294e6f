/**
 * The documentation as pages for browsers, which need neither a server nor a network: each page of
 * Markdown is one of HTML, links are checked, listings of urbiscript are coloured as the scanner of
 * the language reads them.
 */
@NullMarked
package org.urbi.site;

import org.jspecify.annotations.NullMarked;
