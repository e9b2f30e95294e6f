package org.urbi.site;

/**
 * A part of a page, under a heading of its own.
 *
 * @param id its anchor
 * @param level how deep it is: 1 for the title of the page
 * @param title the heading
 * @param text what is under it, up to the next heading
 */
record Section(String id, int level, String title, String text) {}
